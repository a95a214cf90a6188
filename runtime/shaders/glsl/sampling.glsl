// Directions in proportion to the lobes of a material, and their density. Twins: LobeSampling.h, step by step. What a
// table has is defined before this file, and so is FBRDF_LOBE_ROW(index), which reads a vec4 of LobeRows.h:
//   FBRDF_LOBES, FBRDF_LOBE_ROWS                 lobes; rows of a knot
//   FBRDF_LOBE_THETAS, FBRDF_LOBE_AZIMUTHS       knots
//   FBRDF_LOBES_BENT                             where they are bent: then there is fbrdfLobeBend

// The lobes of a view direction. Twin: LobeSum.
struct FbrdfLobeSum {
    vec3 cosine;                // weight of the cosine about the normal
    vec4 lobes[FBRDF_LOBES];    // weight and level
    vec3 axes[FBRDF_LOBES];     // unit
};

// A lobe as two stretched cosines about one axis.
struct FbrdfLobePart {
    mat3 frame;     // y across the plane of wo and the axis, z the axis
    vec4 widths;    // along x and y, of the lower and the upper level
    vec2 shares;
};

struct FbrdfLobeMixture {
    float cosine;   // share of the cosine about the normal
    FbrdfLobePart parts[FBRDF_LOBES];
};

// A row between the knots about wo; places: from fbrdfLobeKnot.
vec4 fbrdfLobeRow(vec2 theta, vec2 azimuth, int row)
{
    int at = FBRDF_LOBE_ROWS * (int(azimuth.x) * FBRDF_LOBE_THETAS + int(theta.x)) + row;
    vec4 value = mix(FBRDF_LOBE_ROW(at), FBRDF_LOBE_ROW(at + FBRDF_LOBE_ROWS), theta.y);
#if FBRDF_LOBE_AZIMUTHS > 1
    at += FBRDF_LOBE_ROWS * FBRDF_LOBE_THETAS;
    value = mix(value, mix(FBRDF_LOBE_ROW(at), FBRDF_LOBE_ROW(at + FBRDF_LOBE_ROWS), theta.y), azimuth.y);
#endif
    return value;
}

FbrdfLobeSum fbrdfLobesAt(vec3 wo)
{
    float last = float(FBRDF_LOBE_THETAS) - 1.0, lastAzimuth = max(1.0, float(FBRDF_LOBE_AZIMUTHS) - 1.0);
    vec2 theta = fbrdfLobeKnot(fbrdfThetaPosition(length(wo.xy), wo.z, last), last);
    vec2 azimuth = vec2(0.0);
#if FBRDF_LOBE_AZIMUTHS > 1
    azimuth = fbrdfLobeKnot(fbrdfAzimuthPosition(wo.xy, lastAzimuth), lastAzimuth);
#endif
    FbrdfLobeSum sum;
    vec4 first = fbrdfLobeRow(theta, azimuth, 0);
    sum.cosine = first.rgb;
    for (int k = 0; k < FBRDF_LOBES; ++k) {
        sum.lobes[k] = fbrdfLobeRow(theta, azimuth, 1 + k);
#ifdef FBRDF_LOBES_BENT
        sum.axes[k] = fbrdfBentAxis(wo, (float(k) - 0.5 * (float(FBRDF_LOBES) - 1.0)) * fbrdfLobeBend);
#else
        float tilt = first.w;
        if (k > 0) {
            vec4 tilts = fbrdfLobeRow(theta, azimuth, FBRDF_LOBE_ROWS - 1);
            tilt = k == 1 ? tilts.x : tilts.y;
        }
        sum.axes[k] = fbrdfTiltedAxis(vec3(0.0, 0.0, 1.0), wo, wo.z, tilt * exp2(sum.lobes[k].w - 6.0));
#endif
    }
    return sum;
}

// Widths along and across the plane of incidence; level: whole. The numbers are those of LobeSampling.cpp.
vec2 fbrdfSampledWidths(float level, float halfCosine)
{
    bool narrowest = level < 0.5;
    float fade = 1.0 - level / 6.0;
    float along = narrowest ? 0.45 : 0.7 * fade, across = narrowest ? 0.5 : 0.5 * fade;
    float width = exp2(level - 6.0) * (narrowest ? 0.8 : 1.0 - 0.005 * level);
    return vec2(width * pow(halfCosine, -along), width * pow(halfCosine, across));
}

mat3 fbrdfPartAxes(vec3 wo, vec3 axis)
{
    vec3 across = cross(wo, axis);
    float square = dot(across, across);
    vec3 y = square > 1e-8 ? across / sqrt(square) : fbrdfLobeFrame(axis)[1];
    return mat3(cross(y, axis), y, axis);
}

float fbrdfStretchedDensity(vec2 widths, vec3 w)
{
    if (!(w.z > 0.0)) return 0.0;
    float x = w.x / widths.x, y = w.y / widths.y, norm = x * x + y * y + w.z * w.z;
    return w.z / (3.14159265 * widths.x * widths.y * norm * norm);
}

FbrdfLobeMixture fbrdfLobeMixture(vec3 wo)
{
    FbrdfLobeSum sum = fbrdfLobesAt(wo);
    vec3 mean = vec3(1.0 / 3.0);
    float total = dot(sum.cosine, mean);
    for (int k = 0; k < FBRDF_LOBES; ++k) total += dot(sum.lobes[k].rgb, mean);
    float scale = total > 0.0 ? 1.0 / total : 0.0;
    float cosine = total > 0.0 ? scale * dot(sum.cosine, mean) : 1.0;
    float more = clamp(0.1 * cosine, 0.005, 0.05);
    FbrdfLobeMixture mixture;
    mixture.cosine = more + (1.0 - more) * cosine;
    for (int k = 0; k < FBRDF_LOBES; ++k) {
        float level = clamp(sum.lobes[k].w, 0.0, 6.0), lower = min(floor(level), 5.0);
        float halfCosine = max(0.01, sqrt(max(0.0, 0.5 + 0.5 * dot(wo, sum.axes[k]))));
        mixture.parts[k].frame = fbrdfPartAxes(wo, sum.axes[k]);
        mixture.parts[k].widths =
            vec4(fbrdfSampledWidths(lower, halfCosine), fbrdfSampledWidths(lower + 1.0, halfCosine));
        float share = (1.0 - more) * scale * dot(sum.lobes[k].rgb, mean);
        mixture.parts[k].shares = share * vec2(1.0 - (level - lower), level - lower);
    }
    return mixture;
}

// The density in 1/sr with which fbrdfSampleMixture draws wi.
float fbrdfMixturePdf(FbrdfLobeMixture mixture, vec3 wi)
{
    float sum = mixture.cosine * max(0.0, wi.z) / 3.14159265;
    for (int k = 0; k < FBRDF_LOBES; ++k) {
        FbrdfLobePart part = mixture.parts[k];
        vec3 local = wi * part.frame;
        sum += part.shares.x * fbrdfStretchedDensity(part.widths.xy, local) +
               part.shares.y * fbrdfStretchedDensity(part.widths.zw, local);
    }
    return sum;
}

// A direction, perhaps below the horizon, and its density; u: two numbers in [0, 1).
vec4 fbrdfSampleMixture(FbrdfLobeMixture mixture, vec2 u)
{
    float left = u.x, share = mixture.cosine;
    mat3 frame = mat3(1.0);
    vec2 widths = vec2(1.0);
    for (int k = 0; k < FBRDF_LOBES; ++k) {
        FbrdfLobePart part = mixture.parts[k];
        if (left >= share && part.shares.x > 0.0) {
            left -= share;
            share = part.shares.x;
            frame = part.frame;
            widths = part.widths.xy;
        }
        if (left >= share && part.shares.y > 0.0) {
            left -= share;
            share = part.shares.y;
            frame = part.frame;
            widths = part.widths.zw;
        }
    }
    float radius2 = clamp(left / share, 0.0, 1.0);
    float radius = sqrt(radius2), azimuth = 6.28318531 * u.y;
    vec3 local = vec3(widths * radius * vec2(cos(azimuth), sin(azimuth)), sqrt(max(0.0, 1.0 - radius2)));
    vec3 wi = frame * normalize(local);
    return vec4(wi, fbrdfMixturePdf(mixture, wi));
}

vec4 fbrdfSampleLobes(vec3 wo, vec2 u)
{
    return fbrdfSampleMixture(fbrdfLobeMixture(wo), u);
}

float fbrdfLobePdf(vec3 wo, vec3 wi)
{
    return fbrdfMixturePdf(fbrdfLobeMixture(wo), wi);
}
