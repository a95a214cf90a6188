// CursorProbe.h - what is under a pixel: the point, the light that matters most there, the BRDF in
// its plane of incidence, the samples near that plane and the texels that are read. No window and
// no GL. Conventions: fbrdf/brdf/Conventions.h.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/scene/CpuRenderer.h>
#include <fbrdf/scene/Lights.h>
#include <fbrdf/sources/Source.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

/// A point that a pixel sees, and the view from it.
struct CursorHit {
    int instance = 0;
    Vec3d position{0.0};  ///< world space
    ShadingFrame<double> frame;
    Vec3d wo{0.0};  ///< local; below the horizon where the back of a surface is seen
};

/// What is at a place of a picture, given in shares of its width and height from the top left.
/// Nothing where no instance is.
std::optional<CursorHit> hitAt(const std::vector<scene::Instance>& instances, const gl::View& view,
                               const Vec2<double>& place);

/// The light that sends most to a point: its irradiance times the cosine, mean of the channels.
struct ProbeLight {
    Vec3d wi{0.0};       ///< local
    std::string name;    ///< "light 2", "area light 1" (its centre), or "no light: mirror"
    bool isLit = false;  ///< false: wi is the mirror direction of wo
};
ProbeLight strongestLight(const CursorHit& hit, const scene::LightSet& lights);

/// Degrees.
struct ProbeAngles {
    double theta_i = 0, theta_o = 0;
    double phi = 0;  ///< between the azimuths of light and view, in [0, 180]
    double theta_h = 0, theta_d = 0, phi_d = 0;
};
ProbeAngles anglesOf(const DirectionPair<double>& pair);

/// f where light comes from wi and the view is in the plane of the normal and wi.
struct PolarPoint {
    double theta = 0;  ///< of the view, degrees in [-90, 90]; > 0 on the side that wi is not on
    double f = 0;      ///< mean of the channels, 1/sr
};
using PolarCurve = std::vector<PolarPoint>;

/// A direction in that plane.
Vec3d inPlane(const Vec3d& wi, double thetaDegrees);
/// Of views every degree.
PolarCurve polarCurve(const scene::Brdf& brdf, const Vec3d& wi);
/// Where a point is in a plot in which views are drawn as they are, the normal upwards and the
/// light to the left, at a distance that is the cube root of f / most: of length at most 1.
Vec2<double> plotted(const PolarPoint& point, double most);
/// The largest f of curves, > 0.
double mostOf(const std::vector<PolarCurve>& curves);

/// The samples of a source, ready to be asked for.
class PlaneSamples {
public:
    /// Reads all samples; of a source of more than four million only every n-th.
    explicit PlaneSamples(const Source& source);

    /// Those whose light is within `tolerance` degrees of wi, and whose view is so near to the
    /// plane of incidence; of an isotropic source turned about the normal so that their light is in
    /// that plane. At most 500, evenly chosen.
    PolarCurve near(const Vec3d& wi, double tolerance) const;
    size_t size() const { return samples_.size(); }

private:
    bool isotropic_;
    std::vector<Sample> samples_;  ///< by falling wi.z
};
constexpr double kPlaneTolerance = 3.0;  ///< degrees, as the window asks

/// One look-up of one table.
struct TexelRead {
    int table = 0;
    std::string name;        ///< "q(h)"
    Vec3d position{0.0};     ///< in texels, unused coordinates 0
    Stencil<double> texels;  ///< that are mixed
    Vec3d value{0.0};        ///< F, of the mixture
};
std::vector<TexelRead> texelsRead(const Material& material, const DirectionPair<double>& pair);

/// The texels of a table, or of its slice z, as a picture whose sRGB codes rise evenly with log
/// |F|, from the least to the largest value of the table, over at most 12 stops.
scene::Image mapPicture(const Table& table, int z);

}  // namespace fbrdf::viewer
