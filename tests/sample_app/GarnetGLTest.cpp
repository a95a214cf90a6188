// GarnetGLTest.cpp - the knot of the 2001 garnet red maps under two lights, drawn by the runtime
// from what the reader makes of the files, against alpha p(wi) q(h) p(wo) evaluated here, from the
// PNGs themselves: nothing of the library but the rasteriser and the mesh is shared.
#include "GlPictures.h"
#include "PictureDifference.h"

#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/scene/Camera.h>
#include <gtest/gtest.h>
#include <support/DataDir.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <locale>
#include <string>

namespace fbrdf::scene {
namespace {

constexpr int kSize = 128;
constexpr double kCode = 1.0 / 255.0;  // to one code
// The authors' viewer multiplied garnet red by 5; so do we, which makes the picture fill [0, 1].
constexpr double kGain = 5.0;

/// An 8-bit map as the paper defines it: bilinear, texel centres at (i + 1/2) / n, row 0 at v = 0.
class ParabolicMap {
public:
    explicit ParabolicMap(const std::string& path)
    {
        const auto file = OIIO::ImageInput::open(path);
        if (!file) throw std::runtime_error("cannot open " + path);
        size_ = file->spec().width;
        channels_ = file->spec().nchannels;
        codes_.resize(static_cast<size_t>(size_ * size_ * channels_));
        file->read_image(0, 0, 0, channels_, OIIO::TypeDesc::UINT8, codes_.data());
    }

    /// u = ((7/8) x + z + 1) / (2 (z + 1)), v likewise with y.
    Vec3d at(const Vec3d& w) const
    {
        const double u = (0.875 * w.x + w.z + 1.0) / (2.0 * (w.z + 1.0));
        const double v = (0.875 * w.y + w.z + 1.0) / (2.0 * (w.z + 1.0));
        const double x = u * size_ - 0.5, y = v * size_ - 0.5;
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        const double a = x - i, b = y - j;
        return (1.0 - b) * ((1.0 - a) * texel(i, j) + a * texel(i + 1, j)) +
               b * ((1.0 - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
    }

private:
    Vec3d texel(int i, int j) const
    {
        i = std::clamp(i, 0, size_ - 1);
        j = std::clamp(j, 0, size_ - 1);
        Vec3d value;
        for (int c = 0; c < 3; ++c)
            value[c] = codes_[static_cast<size_t>((j * size_ + i) * channels_ + c)] / 255.0;
        return value;
    }
    int size_ = 0, channels_ = 0;
    std::vector<uint8_t> codes_;
};

Vec3d alphaOf(const std::string& path)
{
    std::ifstream file(path);
    file.imbue(std::locale::classic());
    std::string line;
    std::getline(file, line);  // title
    std::getline(file, line);  // kind
    Vec3d alpha;
    file >> alpha.r >> alpha.g >> alpha.b;
    return alpha;
}

std::vector<Light> twoLights()
{
    Light key, rim;
    key.position = {2.0f, 2.5f, 3.0f};
    key.intensity = {40.0f, 38.0f, 36.0f};
    rim.position = {-3.0f, 0.5f, 1.5f};
    rim.intensity = {9.0f, 12.0f, 18.0f};
    return {key, rim};
}

/// The picture by docs/method.md, Eq. 2 and 6, written out.
Image direct(const Mesh& mesh, const gl::View& view, const Vec3d& eye)
{
    const std::string base = test::dataPath("waterloo_hf/garnetred/garnetred64");
    const ParabolicMap p(base + "_0.png"), q(base + "_1.png");
    const Vec3d alpha = alphaOf(base + ".txt");
    const Fragments fragments = rasterise({{&mesh}}, view, kSize, kSize);
    Image image(kSize, kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const Fragment& fragment = fragments.at(x, y);
            if (!fragment.covered()) continue;
            const Vec3d position = interpolate<Vec3d>(mesh.positions, mesh, fragment);
            const Vec3d n = glm::normalize(interpolate<Vec3d>(mesh.normals, mesh, fragment));
            Vec3d t = interpolate<Vec3d>(mesh.tangents, mesh, fragment);
            t = glm::normalize(t - n * glm::dot(n, t));
            const Vec3d s = glm::cross(n, t);
            const auto local = [&](const Vec3d& w) {
                return Vec3d(glm::dot(t, w), glm::dot(s, w), glm::dot(n, w));
            };
            const Vec3d wo = local(glm::normalize(eye - position));
            Vec3d sum(0.0);
            for (const Light& light : twoLights()) {
                const Vec3d to = Vec3d(light.position) - position;
                const Vec3d wi = local(glm::normalize(to));
                if (wi.z <= 0.0 || wo.z <= 0.0) continue;
                sum += alpha * p.at(wi) * q.at(glm::normalize(wi + wo)) * p.at(wo) * wi.z *
                       Vec3d(light.intensity) / glm::dot(to, to);
            }
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<float>(sum[c]);
            image.pixel(x, y)[3] = 1.0f;
        }
    return image;
}

struct Difference {
    double linear = 0.0;  ///< of kGain x radiance clamped to [0, 1]
    int codes = 0;        ///< of the sRGB bytes
    double brightest = 0.0;
};

Difference differenceOf(const Image& a, const Image& b)
{
    Difference result;
    for (size_t i = 0; i < a.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        const float x = std::min(1.0f, static_cast<float>(kGain) * a.rgba[i]);
        const float y = std::min(1.0f, static_cast<float>(kGain) * b.rgba[i]);
        result.linear = std::max(result.linear, std::abs(double(x) - double(y)));
        result.codes = std::max(result.codes, std::abs(srgbCode(x) - srgbCode(y)));
        result.brightest = std::max(result.brightest, double(y));
    }
    return result;
}

class GarnetGL : public testing::TestWithParam<Backend> {};

TEST_P(GarnetGL, KnotUnderTwoLightsIsTheProductOfThePublishedMaps)
{
    FBRDF_NEEDS_DATA("waterloo_hf/garnetred/garnetred64.txt");
    if (!hasBackend(GetParam())) GTEST_SKIP() << "no context on " << backendName(GetParam());
    const Mesh mesh = makeKnot(256, 48);
    const Camera camera;
    Scene scene;
    scene.instances = {{&mesh}};
    scene.lights = twoLights();
    scene.view = viewFromCamera(camera, 1.0, boundsOf(mesh));
    const Material material = readMaterial(test::dataPath("waterloo_hf/garnetred/garnetred64.txt"));
    const Image expected = direct(mesh, scene.view, camera.eye);
    GlPictures pictures(GetParam());
    for (const Technique technique : allTechniques()) {
        const GlPicture drawn = pictures.draw(scene, material, technique, kSize, kSize);
        EXPECT_EQ(compare(drawn.image, expected).coverageDiffers, 0);
        const Difference difference = differenceOf(drawn.image, expected);
        RecordProperty(techniqueName(technique), std::to_string(difference.linear));
        EXPECT_LE(difference.linear, kCode) << techniqueName(technique);
        EXPECT_LE(difference.codes, 1) << techniqueName(technique);
        EXPECT_GT(difference.brightest, 0.5) << "the picture is not black";
    }
    // The tester: another alpha, and the maps exchanged, are seen.
    Material wrong = material;
    wrong.scales[0] *= 1.05f;
    const GlPicture tinted = pictures.draw(scene, wrong, Technique::single, kSize, kSize);
    EXPECT_GT(differenceOf(tinted.image, expected).linear, kCode);
}

INSTANTIATE_TEST_SUITE_P(Backends, GarnetGL, testing::Values(Backend::egl, Backend::osmesa),
                         [](const auto& backend) {
                             return std::string(backendName(backend.param));
                         });

}  // namespace
}  // namespace fbrdf::scene
