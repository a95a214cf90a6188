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

// (low, high) of x; y, distance: intervals. 0.70710678 is an eighth of a turn.
vec2 fbrdfConeBounds(vec3 apex, float radius, vec3 axis, float cosine, float sine, vec2 y, vec2 distance, float slack)
{
    vec3 along = abs(axis.x) > 0.999 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 first = normalize(along - dot(along, axis) * axis), second = cross(axis, first);
    vec2 turn = vec2(1.0, 0.0), bounds = vec2(-1e30, 1e30);
    for (int k = 0; k < 8; ++k) {
        vec3 outwards = cosine < 0.0 ? -axis : cosine * (turn.x * first + turn.y * second) - sine * axis;
        float offset = dot(outwards, apex) - min(cosine, 0.0) * radius;
        turn = 0.70710678 * vec2(turn.x - turn.y, turn.x + turn.y);
        if (abs(outwards.x) < 1e-6) continue;
        vec2 behind = outwards.z * distance, beside = -outwards.y * y;
        float x = (offset + slack + max(behind.x, behind.y) + max(beside.x, beside.y)) / outwards.x;
        if (outwards.x > 0.0) bounds.y = min(bounds.y, x);
        else bounds.x = max(bounds.x, x);
    }
    return bounds;
}
