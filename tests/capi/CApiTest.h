// CApiTest.h - the fixture of tests of the C ABI in a context, and a log that keeps its lines.
#pragma once
#include <fbrdf/fbrdf.hpp>

#include "plain.h"
#include "support/gl/GlTest.h"

#include <string>
#include <vector>

namespace fbrdf::test {

struct Line {
    fbrdf_severity severity;
    fbrdf_result code;
    std::string text;
};
using Lines = std::vector<Line>;

inline void write(void* user, fbrdf_severity severity, fbrdf_result code, const char* text)
{
    static_cast<Lines*>(user)->push_back({severity, code, text});
}

constexpr int kSize = 16;        // pixels of a picture on a side
constexpr float kTexel = 1e-4f;  // tables of floats, one exp2 in the shader

/// The picture of plain_draw.
inline void expectPlainPicture(const std::vector<float>& pixels)
{
    for (size_t i = 0; i < pixels.size(); i += 4) {
        ASSERT_NEAR(pixels[i], 0.25f, kTexel);
        ASSERT_NEAR(pixels[i + 1], 0.5f, kTexel);
        ASSERT_NEAR(pixels[i + 2], 1.0f, kTexel);
        ASSERT_EQ(pixels[i + 3], 1.0f);
    }
}

/// A renderer, and the material of plain.c in it.
struct Plain {
    Lines lines;
    abi::Renderer renderer;
    abi::Material material;
    abi::GpuMaterial gpuMaterial;
};

class CApiTest : public GlTest {
protected:
    fbrdf_renderer_desc rendererDesc(Lines& lines)
    {
        auto desc = abi::describe<fbrdf_renderer_desc>();
        desc.api_version = FBRDF_API_VERSION;
        desc.load = context().loader();
        desc.log = {write, &lines};
        return desc;
    }
    void makePlain(Plain& plain)
    {
        const auto desc = rendererDesc(plain.lines);
        ASSERT_EQ(plain.renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
        ASSERT_EQ(plain.material.create(plain_material, &desc.log), FBRDF_RESULT_OK);
        ASSERT_EQ(plain.gpuMaterial.create(fbrdf_gpu_material_create, plain.renderer.get(),
                                           plain.material.get(), nullptr),
                  FBRDF_RESULT_OK);
    }
};

}  // namespace fbrdf::test
