// What decides whether a light may reach a part of the view. Twin: runtime/plan/src/ClusterGeometry.h, which says what
// the arguments are. An interval is (low, high).

float fbrdfIntervalDistance(vec2 interval, float x)
{
    return max(max(interval.x - x, x - interval.y), 0.0);
}

vec2 fbrdfTileExtent(vec4 lines, float tile, float margin)
{
    float first = tile - margin, last = tile + 1.0 + margin;
    vec2 low = lines.xz + lines.yw * first, high = lines.xz + lines.yw * last;
    vec2 least = min(low, high), most = max(low, high);
    return vec2(min(least.x, least.y), max(most.x, most.y));
}

bool fbrdfConeMissesBox(vec3 toCentre, vec3 halves, vec3 axis, float cosine, float sine)
{
    float along = dot(toCentre, axis);
    vec3 across = toCentre - along * axis;
    float distance = length(across);
    vec3 outwards = max(cosine, 0.0) / max(distance, 1e-30) * across - sine * axis;
    float extent = dot(abs(outwards), halves) + max(-cosine, 0.0) * length(halves);
    return cosine * distance - sine * along > extent;
}
