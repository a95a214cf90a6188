// Poulin and Fournier 1990, "A Model for Anisotropic Reflection": parallel cylinders along the tangent, raised from a
// plane, as the model `poulin-fournier` with height > 0 (whose file derives the visible intervals). The diffuse
// integral is exact, the lobe a Gauss-Legendre rule of 8 points on either side of its peak.
// peerParameters: (half arc, period, centre depth, floor width), (kd / pi, n), (ks normalised, cos of the half arc).
uniform vec4 peerParameters[3];

const float kHalfPi = 1.57079632679490;
vec3 peerT, peerS, peerN, peerWo;
vec2 peerArc, peerFloor;

vec2 peerFlipped(vec2 interval, bool flip)
{
    return flip ? -interval.yx : interval;
}

// psi of the arc's points, and y of the floor's, that see a direction at angle gamma in the section.
void peerVisible(float gamma, out vec2 arc, out vec2 floor_)
{
    float halfArc = peerParameters[0].x, period = peerParameters[0].y, g = abs(gamma);
    float half_ = 0.5 * peerParameters[0].w;
    arc = vec2(-halfArc, halfArc);
    floor_ = vec2(-half_, half_);
    if (g > kHalfPi - halfArc) {
        float cosine = max(cos(g), 1e-6), first = g - kHalfPi;
        float reach = 2.0 * asin(sqrt(min(1.0, 0.5 * period * cosine)));
        arc = vec2(first, min(halfArc, first + reach));
        float highest = 1.0 - peerParameters[0].z * sin(g);
        floor_.y = min(half_, 0.5 * period - highest / cosine);
    }
    arc = peerFlipped(arc, gamma < 0.0);
    floor_ = peerFlipped(floor_, gamma < 0.0);
}

void peerView(FbrdfShadingFrame frame, vec3 wo, float NoV)
{
    peerT = frame.t;
    peerS = frame.s;
    peerN = frame.n;
    peerWo = fbrdfLocal(frame, wo);
    peerVisible(atan(peerWo.y, peerWo.z), peerArc, peerFloor);
}

// (n.h)^exponent (n.wi)(n.wo) at a normal (sine, cosine) of the section.
float peerLobe(float sine, float cosine, vec3 h, vec3 wi, float exponent)
{
    float c = max(sine * h.y + cosine * h.z, 1e-9);
    return exp2(exponent * log2(c)) * (sine * wi.y + cosine * wi.z) * (sine * peerWo.y + cosine * peerWo.z);
}

float peerSide(float lower, float upper, vec3 h, vec3 wi, float exponent)
{
    const vec2 kNode[4] = vec2[4](vec2(0.183434642495650, 0.362683783378362), vec2(0.525532409916329, 0.313706645877887),
                                  vec2(0.796666477413627, 0.222381034453374), vec2(0.960289856497536, 0.101228536290376));
    float middle = 0.5 * (lower + upper), half_ = 0.5 * max(upper - lower, 0.0);
    float sine = sin(middle), cosine = cos(middle), sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        float s = sin(half_ * kNode[i].x), c = cos(half_ * kNode[i].x);
        sum += kNode[i].y * (peerLobe(sine * c - cosine * s, cosine * c + sine * s, h, wi, exponent) +
                             peerLobe(sine * c + cosine * s, cosine * c - sine * s, h, wi, exponent));
    }
    return half_ * sum;
}

vec3 peerBrdf(vec3 toLight, float NoL)
{
    vec3 wi = vec3(dot(peerT, toLight), dot(peerS, toLight), NoL);
    vec3 h = normalize(wi + peerWo);
    float exponent = peerParameters[1].w;
    vec2 arc, floor_;
    peerVisible(atan(wi.y, wi.z), arc, floor_);
    arc = vec2(max(arc.x, peerArc.x), min(arc.y, peerArc.y));
    float diffuse = 0.0, lobe = 0.0;
    if (arc.y > arc.x) {
        float size = arc.y - arc.x, middle = arc.x + arc.y;
        diffuse = 0.5 * (size * (wi.y * peerWo.y + wi.z * peerWo.z) +
                         sin(size) * (cos(middle) * (wi.z * peerWo.z - wi.y * peerWo.y) +
                                      sin(middle) * (wi.z * peerWo.y + wi.y * peerWo.z)));
        float peak = atan(h.y, h.z), split = clamp(peak, arc.x, arc.y);
        float reach = sqrt((split - peak) * (split - peak) + 56.0 / max(exponent, 1.0));
        lobe = peerSide(max(arc.x, peak - reach), split, h, wi, exponent) +
               peerSide(split, min(arc.y, peak + reach), h, wi, exponent);
    }
    float floorLit = max(min(floor_.y, peerFloor.y) - max(floor_.x, peerFloor.x), 0.0) * NoL * peerWo.z;
    diffuse += floorLit;
    lobe += floorLit * exp2(exponent * log2(h.z));
    float perArea = 1.0 / (peerParameters[0].y * NoL * peerWo.z);
    return (peerParameters[1].rgb * diffuse + peerParameters[2].rgb * lobe) * perArea;
}
