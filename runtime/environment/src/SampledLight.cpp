#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/LobeSampling.h>
#include <fbrdf/brdf/SampleLattice.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/environment/SampledLight.h>

namespace fbrdf {

Vec3d sampledLight(const CubeImage& cube, const LobeTable& table, const Reflectance& f,
                   const ShadingFrame<double>& frame, const Vec3d& wo, int samples)
{
    FBRDF_ASSERT(samples, >=, 1);
    const LobeMixture<double> mixture = lobeMixture(table, wo);
    const Vec2<double> lattice(samples, latticeStep(samples));
    Vec3d sum(0.0);
    for (int i = 0; i < samples; ++i) {
        const auto drawn = sampleMixture(mixture, samplePoint(double(i), lattice));
        if (!(drawn.wi.z > 0.0 && drawn.pdf > 0.0)) continue;
        const Vec3d direction = frame.t * drawn.wi.x + frame.s * drawn.wi.y + frame.n * drawn.wi.z;
        const double level = levelOfCell(1.0 / (samples * drawn.pdf), direction, cube.size);
        sum += f(wo, drawn.wi) * (drawn.wi.z / drawn.pdf) * sampleCube(cube, direction, level);
    }
    return sum / double(samples);
}

}  // namespace fbrdf
