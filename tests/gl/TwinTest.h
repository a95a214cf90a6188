// TwinTest.h - GLSL functions against their C++ twins in float, on grids of inputs: the inputs go
// in as a texture, the outputs come back as pixels.
#pragma once
#include <gtest/gtest.h>

#include "support/gl/GlTest.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace fbrdf::test {

constexpr float kRounding = 2e-6f;  // a dozen operations in float, values of order 1
constexpr float kTexels = 1e-4f;    // positions are up to 32 texels, and sqrt near 0 doubles errors

using Vec4 = glm::vec4;

/// The input of one evaluation.
struct Inputs {
    Vec4 a{0.0f}, b{0.0f};
};

class Twin : public GlTest {
protected:
    /// Runs `statements` (which read vec4 a, b and set vec4 result) for all inputs.
    std::vector<Vec4> run(const std::string& statements, const std::vector<Inputs>& inputs);

    void compare(const std::string& statements, const std::vector<Inputs>& inputs,
                 const std::function<Vec4(const Inputs&)>& twin, float tolerance)
    {
        const auto found = run(statements, inputs);
        for (size_t i = 0; i < inputs.size(); ++i) {
            const Vec4 expected = twin(inputs[i]);
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(found[i][c], expected[c],
                            tolerance * std::max(1.0f, std::abs(expected[c])))
                    << statements << "\na = " << inputs[i].a.x << " " << inputs[i].a.y << " "
                    << inputs[i].a.z << " " << inputs[i].a.w << "\nb = " << inputs[i].b.x << " "
                    << inputs[i].b.y << " " << inputs[i].b.z << " " << inputs[i].b.w
                    << "\ncomponent " << c;
        }
    }
};

/// Pairs on a grid of half and difference angles, both above the horizon: a = wo, b = wi.
std::vector<Inputs> pairs();

}  // namespace fbrdf::test
