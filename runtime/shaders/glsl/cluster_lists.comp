// Makes the lists of LightClusters.h: a work group for each 64 clusters of a row, which looks at all lights twice, once to
// count and once to write. Lights are taken in their order, so that every list has them ascending; where in the indices a
// list stands depends on which group comes first.

layout(local_size_x = 64) in;

// See ClusterWork.h: three vectors a slice, then three a light.
layout(std430, binding = 0) readonly buffer FbrdfWork { vec4 fbrdfWork[]; };
// First index and number of each cluster; behind the last, how many indices are in use.
layout(std430, binding = 1) buffer FbrdfLists { ivec2 fbrdfLists[]; };
layout(std430, binding = 2) writeonly buffer FbrdfIndices { int fbrdfIndices[]; };

uniform ivec3 fbrdfClusterGrid;
uniform ivec3 fbrdfListed;       // first light that stands in lists, number of lights, room for indices
uniform float fbrdfTileMargin;

shared uint fbrdfMet[2];         // which of 64 lights meet the row
shared vec2 fbrdfDiscs[64];      // of those: centre and squared radius, in the plane of the row
shared vec2 fbrdfBounds[64];     // and x between which their cones are in the row
shared int fbrdfCounts[64];
shared int fbrdfFirst;

void fbrdfWaitForAll()
{
    memoryBarrierShared();
    barrier();
}

int fbrdfVectorsOf(int light)
{
    return 3 * (fbrdfClusterGrid.z + light);
}

// Low is above high where the cone of a light does not meet the row.
vec2 fbrdfBoundsOf(int light, float radius, vec2 y, vec2 z)
{
    vec4 apex = fbrdfWork[fbrdfVectorsOf(light) + 1];
    if (apex.w <= -1.0) return vec2(-1e30, 1e30);
    vec4 axis = fbrdfWork[fbrdfVectorsOf(light) + 2];
    // More than what sums of a few products round.
    float slack = 1e-6 * (dot(abs(apex.xyz), vec3(1.0)) + radius + max(abs(y.x), abs(y.y)) + z.y);
    return fbrdfConeBounds(apex.xyz, radius, axis.xyz, apex.w, axis.w, y, z, slack);
}

void main()
{
    int lane = int(gl_LocalInvocationIndex);
    ivec3 cell = ivec3(gl_WorkGroupID) * ivec3(64, 1, 1) + ivec3(lane, 0, 0);
    bool isCluster = cell.x < fbrdfClusterGrid.x;
    int cluster = (cell.z * fbrdfClusterGrid.y + cell.y) * fbrdfClusterGrid.x + cell.x;
    vec2 z = fbrdfWork[3 * cell.z].xy;
    vec2 x = fbrdfTileExtent(fbrdfWork[3 * cell.z + 1], float(cell.x), fbrdfTileMargin);
    vec2 y = fbrdfTileExtent(fbrdfWork[3 * cell.z + 2], float(cell.y), fbrdfTileMargin);
    int first = fbrdfListed.x, lights = fbrdfListed.y, all = lights - first;
    // A cluster whose list finds no room has this one: nothing is lost.
    if (gl_WorkGroupID == uvec3(0))
        for (int i = lane; i < all; i += 64) fbrdfIndices[i] = first + i;
    int count = 0, next = 0;
    for (int turn = 0; turn < 2; ++turn) {
        for (int base = first; base < lights; base += 64) {
            if (lane < 2) fbrdfMet[lane] = 0u;
            fbrdfWaitForAll();
            if (base + lane < lights) {
                vec4 sphere = fbrdfWork[fbrdfVectorsOf(base + lane)];
                float depth = fbrdfIntervalDistance(z, -sphere.z), height = fbrdfIntervalDistance(y, sphere.y);
                float left = sphere.w * sphere.w - depth * depth - height * height;
                vec2 bounds = fbrdfBoundsOf(base + lane, sphere.w, y, z);
                fbrdfDiscs[lane] = vec2(sphere.x, left);
                fbrdfBounds[lane] = bounds;
                if (left >= 0.0 && z.x <= z.y && bounds.x <= bounds.y) atomicOr(fbrdfMet[lane / 32], 1u << uint(lane % 32));
            }
            fbrdfWaitForAll();
            for (int word = 0; word < 2; ++word)
                for (uint met = isCluster ? fbrdfMet[word] : 0u; met != 0u; met &= met - 1u) {
                    int k = 32 * word + findLSB(met);
                    float width = fbrdfIntervalDistance(x, fbrdfDiscs[k].x);
                    bool isBeside = x.x > fbrdfBounds[k].y || x.y < fbrdfBounds[k].x;
                    if (isBeside || width * width > fbrdfDiscs[k].y) continue;
                    if (turn == 1) fbrdfIndices[next++] = base + k;
                    else ++count;
                }
            fbrdfWaitForAll();
        }
        if (turn == 1) break;
        fbrdfCounts[lane] = count;
        fbrdfWaitForAll();
        int before = 0, total = 0;
        for (int i = 0; i < 64; ++i) {
            before += i < lane ? fbrdfCounts[i] : 0;
            total += fbrdfCounts[i];
        }
        if (lane == 0)
            fbrdfFirst = atomicAdd(fbrdfLists[fbrdfClusterGrid.x * fbrdfClusterGrid.y * fbrdfClusterGrid.z].x, total);
        fbrdfWaitForAll();
        bool isRoom = fbrdfFirst <= fbrdfListed.z - total;
        next = fbrdfFirst + before;
        if (isCluster) fbrdfLists[cluster] = isRoom ? ivec2(next, count) : ivec2(0, all);
        if (!isRoom) return;
    }
}
