// The programs of sample_app/examples in a window without a display (Xvfb): what they draw is the
// BRDF evaluated on the CPU.
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/plan/Transfer.h>

#include <gtest/gtest.h>

#include "support/TemporaryDir.h"

#include <sys/wait.h>

namespace fbrdf::test {
namespace {

/// A glossy lobe over theta_h on a floor, of another width in each channel.
Material glossy()
{
    Material material;
    material.form = formHdio({8, 2, 2});
    for (const TableSpec& spec : material.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.texels.assign(3 * static_cast<size_t>(texelCount(spec.domain)), 0.0f);
        material.tables.push_back(table);
    }
    std::vector<float>& lobe = material.tables[0].texels;
    for (size_t i = 0; i < lobe.size(); ++i) {
        const auto knot = static_cast<float>(i / 3 % 8), channel = static_cast<float>(i % 3);
        lobe[i] = 1.0f - knot * (0.5f + 0.25f * channel);
    }
    material.scales = {Vec3f(0.5f)};
    return material;
}

/// A picture of P6, rows from the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;

    explicit Picture(const std::string& path)
    {
        std::ifstream file(path, std::ios::binary);
        std::string magic;
        int most = 0;
        file >> magic >> width >> height >> most;
        file.get();
        if (magic != "P6" || most != 255 || width <= 0 || height <= 0) return;
        rgb.resize(3 * static_cast<size_t>(width) * static_cast<size_t>(height));
        file.read(reinterpret_cast<char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
        if (!file) rgb.clear();
    }
};

/// What is seen along a ray from (0, 0, 4) with these coordinates of the picture in [-1, 1]: the
/// unit sphere under one point light, in sRGB codes; nothing within `margin` of its outline.
std::optional<Vec3d> expectedAt(const Material& material, double x, double y)
{
    constexpr double kMargin = 0.05;  // of 1 - distance^2 to the axis: 3 pixels of 512
    const double scale = std::tan(17.5 * kPi / 180.0);
    const Vec3d ray = glm::normalize(Vec3d(x * scale, y * scale, -1.0)), eye(0.0, 0.0, 4.0);
    const double middle = -glm::dot(ray, eye), inside = middle * middle - 15.0;
    if (std::abs(inside) < kMargin) return std::nullopt;
    if (inside < 0.0) return Vec3d(0.0);
    const Vec3d normal = eye + ray * (middle - std::sqrt(inside));
    const Vec3d tangent = glm::normalize(Vec3d(normal.z, 0.0, -normal.x));
    const Vec3d bitangent = glm::cross(normal, tangent), toLight = Vec3d(2.0, 3.0, 3.0) - normal;
    const auto local = [&](const Vec3d& v) {
        return Vec3d(glm::dot(v, tangent), glm::dot(v, bitangent), glm::dot(v, normal));
    };
    const Vec3d wi = local(glm::normalize(toLight));
    const double irradiance = 30.0 * std::max(0.0, wi.z) / glm::dot(toLight, toLight);
    const Vec3d radiance = evaluate<double>(material, local(-ray), wi) * irradiance;
    Vec3d codes(0.0);
    for (int c = 0; c < 3; ++c) codes[c] = 255.0 * transferred(Transfer::srgb, 1.0, radiance[c]);
    return codes;
}

bool haveXvfb()
{
    return std::system("command -v Xvfb >/dev/null 2>&1") == 0;
}

class Examples : public ::testing::TestWithParam<const char*> {};

TEST_P(Examples, DrawWhatTheCpuComputes)
{
    if (!haveXvfb()) GTEST_SKIP() << "needs Xvfb (Debian: xvfb)";
    const TemporaryDir folder;
    const Material material = glossy();
    writeMaterial(material, folder.file("glossy.fbrdf"));
    const std::string server = "tests/support/with_x.sh env -u WAYLAND_DISPLAY ";
    const std::string command = server + GetParam() + " " + folder.file("glossy.fbrdf") + " 2 " +
                                folder.file("picture.ppm");
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const Picture picture(folder.file("picture.ppm"));
    ASSERT_EQ(picture.width, 512);
    ASSERT_EQ(picture.height, 512);
    ASSERT_FALSE(picture.rgb.empty());
    // Half a code of rounding, and what 64 rings of triangles leave of a sphere's normals.
    constexpr double kCodes = 2.0;
    int bright = 0, compared = 0;
    for (int row = 0; row < 512; ++row)
        for (int column = 0; column < 512; ++column) {
            const auto expected =
                expectedAt(material, (column - 255.5) / 256.0, (255.5 - row) / 256.0);
            if (!expected) continue;
            for (int c = 0; c < 3; ++c) {
                const int code = picture.rgb[static_cast<size_t>(3 * (512 * row + column) + c)];
                ASSERT_NEAR(code, (*expected)[c], kCodes) << column << ' ' << row << ' ' << c;
                bright += code > 100 && code < 255;
            }
            ++compared;
        }
    EXPECT_GT(compared, 230000);
    EXPECT_GT(bright, 20000);  // the sphere is lit, and not all white
}

TEST_P(Examples, RefuseWhatTheyCannotDo)
{
    const std::string program = GetParam();
    const auto exitCode = [](const std::string& command) {
        return WEXITSTATUS(std::system((command + " >/dev/null 2>&1").c_str()));
    };
    EXPECT_EQ(exitCode(program), 2);
    if (!haveXvfb()) GTEST_SKIP() << "needs Xvfb (Debian: xvfb)";
    const std::string server = "tests/support/with_x.sh ";
    EXPECT_EQ(exitCode(server + program + " no-such-file"), 1);
}

INSTANTIATE_TEST_SUITE_P(All, Examples,
                         ::testing::Values(FBRDF_GLFW_HOST, FBRDF_GLFW_HOST_C, FBRDF_OWN_SHADERS),
                         [](const auto& parameter) {
                             return std::filesystem::path(parameter.param).filename().string();
                         });

}  // namespace
}  // namespace fbrdf::test
