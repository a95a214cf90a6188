// Lights with a shape. An area light is five vectors in eye space, see AreaVectors.h. Twins: LobeContour.h and
// AreaContour.h, step by step.

// The two stretched cosines whose mixture is a lobe.
struct FbrdfLevelMixture {
    vec2 squaredWidth, share;
};

FbrdfLevelMixture fbrdfLevelMixture(float level)
{
    float clamped = clamp(level, 0.0, 6.0);
    float lower = min(floor(clamped), 5.0);
    float squared = exp2(2.0 * (lower - 6.0));
    return FbrdfLevelMixture(vec2(squared, 4.0 * squared), vec2(1.0 - clamped + lower, clamped - lower));
}

// Of two cosines. Fitted to acos(c) / sqrt(1 - c^2) on [0, 1]; beyond 90 degrees the angle is pi less that of -c. 1e-12
// keeps an edge finite that passes through the point itself.
vec2 fbrdfAngleOverSine(vec2 cosine)
{
    vec2 c = min(abs(cosine), vec2(1.0));
    vec2 ratio = (1.570796268 + c * (1.100158696 + c * (0.0568270455 - c * 0.00338514545)))
               / (1.0 + c * (1.336998785 + c * 0.387398181));
    vec2 obtuse = 3.14159265 * inversesqrt(max(1.0 - c * c, vec2(1e-12))) - ratio;
    return vec2(cosine.x >= 0.0 ? ratio.x : obtuse.x, cosine.y >= 0.0 ? ratio.y : obtuse.y);
}

// Baum, Rushmeier, Winget 1989, Eq. 6, for the directions that the inverse stretch maps to (Heitz et al. 2016, Eq. 5).
vec2 fbrdfLobeEdge(vec3 axis, vec2 squaredWidth, vec3 a, vec3 b)
{
    float alongA = dot(axis, a), alongB = dot(axis, b);
    vec3 acrossA = a - alongA * axis, acrossB = b - alongB * axis;
    vec2 lengths = (dot(acrossA, acrossA) + squaredWidth * (alongA * alongA))
                 * (dot(acrossB, acrossB) + squaredWidth * (alongB * alongB));
    vec2 scale = inversesqrt(max(lengths, vec2(1e-30)));
    vec2 cosine = (dot(acrossA, acrossB) + squaredWidth * (alongA * alongB)) * scale;
    return dot(axis, cross(acrossA, acrossB)) * scale * fbrdfAngleOverSine(cosine);
}

// The vector irradiance of an elliptic cone is along its axis (Heitz and Hill 2017, section 4).
vec2 fbrdfLobeInCap(vec2 squaredWidth, float cosine, float squaredSine)
{
    float z2 = cosine * cosine, cosine2 = 1.0 - squaredSine;
    vec2 xx = squaredWidth * (squaredSine - z2);
    vec2 negated = squaredWidth * (squaredSine * cosine2);
    vec2 trace = xx + (squaredSine - 1.0 + z2);
    vec2 gap = sqrt(trace * trace + 4.0 * negated);
    vec2 positive = vec2(trace.x > 0.0 ? 0.5 * (trace.x + gap.x) : 2.0 * negated.x / (gap.x - trace.x),
                         trace.y > 0.0 ? 0.5 * (trace.y + gap.y) : 2.0 * negated.y / (gap.y - trace.y));
    vec2 lean = (positive - xx) / (positive + squaredWidth * cosine2);
    return (cosine > 0.0 ? 1.0 : -1.0) * positive / gap * sqrt(max(lean, vec2(0.0)));
}

// The outline of a light as a point sees it: point i of arc k is
//     centre<k> + r (along<k> cos a + across<k> sin a),   a from -angle[k] to angle[k] in equal steps,
// where r is 1 for the first and the last point and bulge[k] between. axis: of a circle, where squaredSine is not 0.
struct FbrdfAreaContour {
    vec3 centre0, along0, across0, centre1, along1, across1;
    vec2 angle, bulge;
    float points;
    vec3 axis;
    float squaredSine;
    bool isAround;
};

// 8 steps of an arc: the polygon has the area of the sector.
float fbrdfBulge(float angle)
{
    float stride = angle / 4.0;
    float area = stride > 1e-3 ? 2.0 * angle / sin(stride) : 8.0;
    return (sqrt(1.0 + 6.0 * area) - 1.0) / 6.0;
}

// Two halves of 8 points, which share none; the polygon has the area of the circle.
FbrdfAreaContour fbrdfWholeCircle(vec3 centre, vec3 along, vec3 across)
{
    along *= 1.01300156;
    across *= 1.01300156;
    return FbrdfAreaContour(centre, along, across, centre, -along, -across, vec2(1.37444679), vec2(1.0), 8.0,
                            vec3(0.0), 0.0, false);
}

FbrdfAreaContour fbrdfSphereContour(vec3 centre, float radius)
{
    float squaredSine = radius * radius / dot(centre, centre);
    vec3 axis = normalize(centre);
    mat3 frame = fbrdfLobeFrame(axis);
    float sine = sqrt(squaredSine);
    FbrdfAreaContour contour = fbrdfWholeCircle(axis * sqrt(max(1.0 - squaredSine, 0.0)), frame[0] * sine,
                                                frame[1] * sine);
    contour.axis = axis;
    contour.squaredSine = squaredSine;
    return contour;
}

// The hull of two spheres: arcs of both outlines, and the great circles that touch them.
FbrdfAreaContour fbrdfTubeContour(vec3 a, vec3 b, float radius)
{
    float sineA = radius * inversesqrt(dot(a, a)), sineB = radius * inversesqrt(dot(b, b));
    vec3 axisA = normalize(a), axisB = normalize(b), normal = cross(axisA, axisB);
    float sine = length(normal), cosine = dot(axisA, axisB);
    float cosineA = sqrt(max(1.0 - sineA * sineA, 0.0)), cosineB = sqrt(max(1.0 - sineB * sineB, 0.0));
    float touchA = sineB - sineA * cosine, touchB = sineA - sineB * cosine;
    if (!(touchA > -cosineA * sine)) return fbrdfSphereContour(a, radius);
    if (!(touchB > -cosineB * sine)) return fbrdfSphereContour(b, radius);
    vec3 across = normal / sine;
    vec2 angle = acos(clamp(vec2(touchA, touchB) / max(vec2(cosineA, cosineB) * sine, vec2(1e-30)), -1.0, 1.0));
    return FbrdfAreaContour(axisA * cosineA, cross(axisA, across) * sineA, across * sineA,
                            axisB * cosineB, cross(across, axisB) * sineB, -across * sineB,
                            angle, vec2(fbrdfBulge(angle.x), fbrdfBulge(angle.y)), 9.0, vec3(0.0), 0.0, false);
}

FbrdfAreaContour fbrdfFacetContour(vec3 a, vec3 b, vec3 c, vec3 d)
{
    return FbrdfAreaContour(0.5 * (a + b), vec3(0.0), 0.5 * (b - a), 0.5 * (c + d), vec3(0.0), 0.5 * (d - c),
                            vec2(1.57079633), vec2(1.0), 2.0, vec3(0.0), 0.0, false);
}

// Of 0 from a segment, squared.
float fbrdfSquaredDistance(vec3 a, vec3 b)
{
    vec3 axis = b - a;
    vec3 nearest = a + clamp(-dot(a, axis) / max(dot(axis, axis), 1e-30), 0.0, 1.0) * axis;
    return dot(nearest, nearest);
}

// Four of the vectors of a light, and the point that sees it.
FbrdfAreaContour fbrdfAreaContour(vec4 a, vec4 b, vec4 c, vec4 d, vec3 point)
{
    // Not mod, which divides: a quotient of whole numbers that is a bit too small would be floored to the one before.
    float kind = d.w - 8.0 * floor(0.125 * d.w);
    vec3 first = a.xyz - point;
    FbrdfAreaContour nothing = FbrdfAreaContour(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0),
                                                vec2(0.0), vec2(0.0), 0.0, vec3(0.0), 0.0, false);
    if (kind > 3.5) {
        bool isTube = kind > 4.5;
        vec3 second = isTube ? b.xyz - point : first;
        float radius = isTube ? c.x : b.x;
        nothing.isAround = fbrdfSquaredDistance(first, second) <= radius * radius;
        if (nothing.isAround) return nothing;
        if (isTube) return fbrdfTubeContour(first, second, radius);
        return fbrdfSphereContour(first, radius);
    }
    bool isTwoSided = kind - 2.0 * floor(0.5 * kind) > 0.5;
    vec3 second = b.xyz - point, third = c.xyz - point, fourth = d.xyz - point;
    bool isDisc = kind > 1.5;
    vec3 normal = isDisc ? cross(b.xyz, c.xyz) : cross(third - first, fourth - second);
    float height = -dot(normal, first);
    if (!(isTwoSided ? height != 0.0 : height > 0.0)) return nothing;
    if (isDisc) return fbrdfWholeCircle(first, b.xyz, c.xyz);
    return fbrdfFacetContour(first, second, third, fourth);
}

vec3 fbrdfContourPoint(FbrdfAreaContour contour, float i)
{
    bool isSecond = i >= contour.points;
    float place = isSecond ? i - contour.points : i, last = contour.points - 1.0;
    float angle = (isSecond ? contour.angle.y : contour.angle.x) * (2.0 * place / last - 1.0);
    float bulge = isSecond ? contour.bulge.y : contour.bulge.x;
    float r = place < 0.5 || place > last - 0.5 ? 1.0 : bulge;
    vec3 along = isSecond ? contour.along1 : contour.along0, across = isSecond ? contour.across1 : contour.across0;
    return (isSecond ? contour.centre1 : contour.centre0) + r * (along * cos(angle) + across * sin(angle));
}

// Corners in the plane count as below, so that what leaves the upper half also enters it. leaves, enters: the point, and
// how steeply; the steepest edge counts, as rounding may take a corner in the plane to the other side and back.
bool fbrdfCutEdge(vec3 n, inout vec3 a, inout vec3 b, inout vec4 leaves, inout vec4 enters)
{
    float heightA = dot(n, a), heightB = dot(n, b);
    if (heightA <= 0.0 && heightB <= 0.0) return false;
    vec3 crossing = a + (b - a) * (heightA / (heightA - heightB));
    if (heightA <= 0.0) a = crossing;
    if (heightA <= 0.0 && heightB - heightA > enters.w) enters = vec4(crossing, heightB - heightA);
    if (heightB <= 0.0) b = crossing;
    if (heightB <= 0.0 && heightA - heightB > leaves.w) leaves = vec4(crossing, heightA - heightB);
    return true;
}

// The outline cut by the horizon and by the equator of the lobe, edge by edge; the last edge runs along the horizon.
float fbrdfLobeInOutline(FbrdfAreaContour contour, vec3 n, vec3 axis, float level)
{
    FbrdfLevelMixture lobe = fbrdfLevelMixture(level);
    vec4 leaves = vec4(0.0), enters = vec4(0.0), equatorLeaves = vec4(0.0), equatorEnters = vec4(0.0);
    vec2 sum = vec2(0.0);
    int count = 2 * int(contour.points);
    vec3 last = fbrdfContourPoint(contour, float(count - 1));
    for (int i = 0; i <= count; ++i) {
        vec3 a = last, b = enters.xyz;
        bool isAbove = true;
        if (i < count) {
            b = last = fbrdfContourPoint(contour, float(i));
            isAbove = fbrdfCutEdge(n, a, b, leaves, enters);
        } else {
            a = leaves.xyz;
        }
        if (isAbove && fbrdfCutEdge(axis, a, b, equatorLeaves, equatorEnters))
            sum += fbrdfLobeEdge(axis, lobe.squaredWidth, a, b);
    }
    sum += fbrdfLobeEdge(axis, lobe.squaredWidth, equatorLeaves.xyz, equatorEnters.xyz);
    return abs(dot(sum, lobe.share)) / 6.28318531;
}

// The share of a lobe that is inside of the outline and above the horizon of n.
float fbrdfLobeInArea(FbrdfAreaContour contour, vec3 n, vec3 axis, float level)
{
    if (contour.isAround) return 1.0;
    if (contour.points == 0.0) return 0.0;
    if (contour.squaredSine > 0.0) {
        float sine = sqrt(contour.squaredSine), height = dot(n, contour.axis), cosine = dot(axis, contour.axis);
        if (height <= -sine) return 0.0;
        if (height > sine && cosine > sine) {
            FbrdfLevelMixture lobe = fbrdfLevelMixture(level);
            return dot(fbrdfLobeInCap(lobe.squaredWidth, cosine, contour.squaredSine), lobe.share);
        }
    }
    return fbrdfLobeInOutline(contour, n, axis, level);
}
