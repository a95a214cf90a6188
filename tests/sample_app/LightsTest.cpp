// LightsTest.cpp - lights as JSON both ways, and the made ones; no GL.
#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Lights.h>
#include <gtest/gtest.h>
#include <support/DataDir.h>

#include <cmath>

namespace fbrdf::scene {
namespace {

const char* const kTwo = R"({"comment": "ignored", "lights": [
  {"type": "point", "position": [1, 2, 3.5], "intensity": [4, 5, 6], "radius": 7, "name": "key"},
  {"type": "directional", "direction": [0, 3, 4], "intensity": [0.25, 0, 1e-3]}]})";

std::string errorOf(const std::string& text)
{
    try {
        lightsFromJson(text, "l.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        return error.what();
    }
    return {};
}

/// A light with one member replaced (or removed, by "").
std::string pointWith(const std::string& name, const std::string& value)
{
    std::string text = "{\"lights\": [{";
    for (const auto& [key, standard] : {std::pair<std::string, std::string>("type", "\"point\""),
                                        {"position", "[0, 0, 1]"},
                                        {"intensity", "[1, 1, 1]"},
                                        {"radius", "2"}}) {
        const std::string& used = key == name ? value : standard;
        if (!used.empty()) text += "\"" + key + "\": " + used + ", ";
    }
    return text.substr(0, text.size() - 2) + "}]}";
}

TEST(LightJson, ReadsBothTypes)
{
    const std::vector<Light> lights = lightsFromJson(kTwo, "l.json").lights;
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0].type, Light::Type::point);
    EXPECT_EQ(lights[0].position, Vec3f(1.0f, 2.0f, 3.5f));
    EXPECT_EQ(lights[0].intensity, Vec3f(4.0f, 5.0f, 6.0f));
    EXPECT_EQ(lights[0].radius, 7.0f);
    EXPECT_EQ(lights[1].type, Light::Type::directional);
    EXPECT_NEAR(glm::distance(lights[1].position, Vec3f(0.0f, 0.6f, 0.8f)), 0.0f, 1e-7f);
    EXPECT_EQ(lights[1].intensity, Vec3f(0.25f, 0.0f, 1e-3f));
    EXPECT_EQ(lights[1].radius, 0.0f);
    EXPECT_EQ(lightsFromJson("{\"lights\": []}", "l.json").size(), 0u);
}

TEST(LightJson, WritesWhatItReads)
{
    std::vector<Light> lights = makeLights(9, 3);
    lights[4].radius = 0.1f;
    lights[5].type = Light::Type::directional;
    lights[5].position = glm::normalize(lights[5].position);
    const std::vector<Light> again = lightsFromJson(lightsToJson({lights, {}}), "l.json").lights;
    ASSERT_EQ(again.size(), lights.size());
    for (size_t i = 0; i < lights.size(); ++i) {
        EXPECT_EQ(again[i].type, lights[i].type);
        EXPECT_LE(glm::distance(again[i].position, lights[i].position), i == 5 ? 1e-7f : 0.0f);
        EXPECT_EQ(again[i].intensity, lights[i].intensity);
        EXPECT_EQ(again[i].radius, lights[i].radius);
    }
}

TEST(LightJson, ReadsAndWritesSpots)
{
    const auto lights =
        lightsFromJson(
            R"({"lights": [{"type": "spot", "position": [1, 2, 3], "intensity": [4, 5, 6], "radius": 9,
            "axis": [0, 0, -2], "inner_degrees": 15, "outer_degrees": 180}]})",
            "l.json")
            .lights;
    ASSERT_EQ(lights.size(), 1u);
    const Light& light = lights[0];
    EXPECT_TRUE(isValid(light));
    EXPECT_EQ(light.type, Light::Type::spot);
    EXPECT_EQ(light.axis, Vec3f(0.0f, 0.0f, -1.0f));
    EXPECT_FLOAT_EQ(light.innerAngle, static_cast<float>(kPi / 12));
    EXPECT_FLOAT_EQ(light.outerAngle, static_cast<float>(kPi));
    EXPECT_EQ(light.radius, 9.0f);
    const Light again = lightsFromJson(lightsToJson({lights, {}}), "l.json").lights.at(0);
    EXPECT_EQ(again.axis, light.axis);
    EXPECT_FLOAT_EQ(again.innerAngle, light.innerAngle);
    EXPECT_FLOAT_EQ(again.outerAngle, light.outerAngle);
}

TEST(LightJson, RefusesSpotsWithoutACone)
{
    const auto spotWith = [](const std::string& rest) {
        return errorOf(
            R"({"lights": [{"type": "spot", "position": [0, 0, 1], "intensity": [1, 1, 1])" + rest +
            "}]}");
    };
    const std::string axis = R"(, "axis": [0, 0, -1])";
    EXPECT_NE(spotWith("").find("lights[0]: found no 'axis'"), std::string::npos);
    EXPECT_NE(spotWith(axis).find("found no 'inner_degrees'"), std::string::npos);
    EXPECT_NE(spotWith(axis + R"(, "inner_degrees": 30, "outer_degrees": 20)")
                  .find("lights[0].outer_degrees: found 20"),
              std::string::npos);
    EXPECT_NE(spotWith(axis + R"(, "inner_degrees": -1, "outer_degrees": 20)")
                  .find("lights[0].inner_degrees: found -1"),
              std::string::npos);
    EXPECT_NE(spotWith(R"(, "axis": [0, 0, 0], "inner_degrees": 1, "outer_degrees": 20)")
                  .find("lights[0].axis: found a vector of length 0"),
              std::string::npos);
}

const char* const kShapes = R"({"lights": [
  {"type": "sphere", "position": [1, 2, 3], "size": 0.5, "radiance": [1, 2, 3], "radius": 4},
  {"type": "point", "position": [1, 2, 3], "intensity": [4, 5, 6]},
  {"type": "disc", "position": [0, 1, 0], "normal": [0, -2, 0], "size": 2, "radiance": [1, 1, 1]},
  {"type": "rectangle", "position": [0, 0, 1], "axis_u": [1, 0, 0], "axis_v": [0, 2, 0],
   "radiance": [5, 5, 5], "two_sided": true},
  {"type": "tube", "from": [0, 0, 0], "to": [1, 0, 0], "size": 0.1, "radiance": [1, 0, 0]},
  {"type": "polygon", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "radiance": [1, 1, 0]}]})";

TEST(LightJson, ReadsAndWritesLightsWithAShape)
{
    const LightSet set = lightsFromJson(kShapes, "l.json");
    ASSERT_EQ(set.lights.size(), 1u);
    ASSERT_EQ(set.areaLights.size(), 5u);
    for (const LightSet& s : {set, lightsFromJson(lightsToJson(set), "l.json")}) {
        EXPECT_EQ(s.areaLights[0].shape, AreaLight::Shape::sphere);
        EXPECT_EQ(s.areaLights[0].position, Vec3f(1, 2, 3));
        EXPECT_EQ(s.areaLights[0].radiance, Vec3f(1, 2, 3));
        EXPECT_EQ(s.areaLights[0].size, 0.5f);
        EXPECT_EQ(s.areaLights[0].radius, 4.0f);
        EXPECT_EQ(s.areaLights[1].normal, Vec3f(0, -1, 0));
        EXPECT_FALSE(s.areaLights[1].twoSided);
        EXPECT_EQ(s.areaLights[2].axisV, Vec3f(0, 2, 0));
        EXPECT_TRUE(s.areaLights[2].twoSided);
        EXPECT_EQ(s.areaLights[3].end, Vec3f(1, 0, 0));
        EXPECT_EQ(s.areaLights[4].vertices.size(), 3u);
        EXPECT_EQ(s.areaLights[4].vertices[1], Vec3f(1, 0, 0));
    }
    const std::string text = kShapes;
    for (size_t size = 0; size < text.size(); ++size) EXPECT_NE(errorOf(text.substr(0, size)), "");
}

TEST(LightJson, RefusesShapesThatAreNone)
{
    const auto of = [](const std::string& rest) {
        return errorOf("{\"lights\": [{\"radiance\": [1, 1, 1], " + rest + "}]}");
    };
    const std::string sphere = R"("type": "sphere", "position": [0, 0, 0], )";
    ASSERT_EQ(of(sphere + "\"size\": 1"), "");
    EXPECT_NE(
        of(sphere + "\"size\": 0").find("lights[0].size: found 0, expected a finite number > 0"),
        std::string::npos);
    EXPECT_NE(of(sphere + "\"size\": -1").find("lights[0].size: found -1"), std::string::npos);
    EXPECT_NE(of(sphere + "\"size\": 1e39").find("lights[0].size: found"), std::string::npos);
    EXPECT_NE(of(sphere + "\"radiant\": 1").find("found no 'size'"), std::string::npos);
    EXPECT_NE(of(R"("type": "rectangle", "position": [0, 0, 0], "axis_u": [1, 0, 0],
                    "axis_v": [2, 0, 0])")
                  .find("lights[0].axis_u, axis_v: found vectors on one line"),
              std::string::npos);
    EXPECT_NE(of(R"("type": "polygon", "vertices": [[0, 0, 0], [1, 0]])")
                  .find("lights[0].vertices[1]: found [1,0]"),
              std::string::npos);
    EXPECT_NE(of(R"("type": "polygon", "vertices": [[0, 0, 0], [1, 0, 0]])")
                  .find("lights[0].vertices: found 2, expected 3 to 256"),
              std::string::npos);
    EXPECT_NE(of(R"("type": "disc", "position": [0, 0, 0], "size": 1, "normal": [0, 0, 0])")
                  .find("lights[0].normal: found a vector of length 0"),
              std::string::npos);
    EXPECT_NE(of(sphere + "\"size\": 1, \"two_sided\": 3").find("two_sided: found 3"),
              std::string::npos);
    EXPECT_NE(errorOf(R"({"lights": [{"type": "sphere", "position": [0, 0, 0], "size": 1}]})")
                  .find("found no 'radiance'"),
              std::string::npos);
    EXPECT_NE(errorOf(R"({"lights": [{"type": "sphere", "position": [0, 0, 0], "size": 1,
                          "radiance": [1, -1, 1]}]})")
                  .find("lights[0].radiance: found a negative"),
              std::string::npos);
}

TEST(LightJson, NamesTheFieldOfAnError)
{
    ASSERT_EQ(errorOf(pointWith("", "")), "") << "the case that is only changed in one place";
    const std::pair<std::string, const char*> cases[] = {
        {pointWith("type", "\"area\""), "l.json: lights[0].type: found \"area\""},
        {pointWith("type", "3"), "l.json: lights[0].type: found 3"},
        {pointWith("type", ""), "l.json: lights[0]: found no 'type'"},
        {pointWith("position", ""), "l.json: lights[0]: found no 'position'"},
        {pointWith("position", "[1, 2]"), "l.json: lights[0].position: found [1,2], expected an"},
        {pointWith("position", "\"up\""), "l.json: lights[0].position: found \"up\""},
        {pointWith("position", "[1, null, 2]"), "l.json: lights[0].position: found null"},
        {pointWith("position", "[1, 1e39, 2]"), "l.json: lights[0].position: found 1e+39"},
        {pointWith("intensity", ""), "l.json: lights[0]: found no 'intensity'"},
        {pointWith("intensity", "[1, -1, 1]"), "l.json: lights[0].intensity: found [1,-1,1]"},
        {pointWith("radius", "-2"), "l.json: lights[0].radius: found -2"},
        {pointWith("radius", "[2]"), "l.json: lights[0].radius: found [2]"},
        {"{\"lights\": [{\"type\": \"directional\", \"direction\": [0, 0, 0]}]}",
         "l.json: lights[0].direction: found a vector of length 0"},
        {"{\"lights\": [3]}", "l.json: lights[0]: found 3, expected an object"},
        {"{\"lights\": {}}", "l.json: found {\"lights\":{}}, expected an object with an array"},
        {"[]", "l.json: found []"},
        {"", "l.json: found [json.exception.parse_error"},
    };
    for (const auto& [text, expected] : cases)
        EXPECT_EQ(errorOf(text).substr(0, std::string(expected).size()), expected) << text;
    EXPECT_NE(errorOf("{\"lights\":\n [1,, 2]}").find("line 2, column 5"), std::string::npos);
}

TEST(LightJson, EveryProperPrefixIsRefused)
{
    const std::string text = kTwo;
    for (size_t size = 0; size < text.size(); ++size) EXPECT_NE(errorOf(text.substr(0, size)), "");
}

TEST(LightJson, DeepNestingAndWildBytesAreRefused)
{
    EXPECT_NE(errorOf(std::string(200000, '[')), "");
    EXPECT_NE(errorOf("\xff\xfe\x00{}"), "");
    EXPECT_NE(errorOf(pointWith("type", "\"\xff\"")), "");
}

TEST(LightJson, ReadsTheStandardSphereLights)
{
    FBRDF_NEEDS_DATA("../standard-lights.json");
    const auto lights = readLights(test::dataPath("../standard-lights.json")).lights;
    EXPECT_EQ(lights.size(), 128u);
    for (const Light& light : lights) EXPECT_NEAR(glm::length(light.position), 1.0f, 1e-6f);
}

TEST(MakeLights, IsDeterministicAndTheSeedMatters)
{
    const auto same = [](const std::vector<Light>& a, const std::vector<Light>& b) {
        return lightsToJson({a, {}}) == lightsToJson({b, {}});
    };
    EXPECT_TRUE(same(makeLights(64, 7), makeLights(64, 7)));
    EXPECT_FALSE(same(makeLights(64, 7), makeLights(64, 8)));
    EXPECT_TRUE(makeLights(0).empty());
}

TEST(MakeLights, TotalIrradianceDoesNotDependOnTheirNumber)
{
    for (const int count : {1, 2, 3, 16, 256}) {
        const auto lights = makeLights(count, 5);
        ASSERT_EQ(lights.size(), static_cast<size_t>(count));
        double total = 0.0;
        for (const Light& light : lights) {
            const double distance2 = glm::dot(Vec3d(light.position), Vec3d(light.position));
            const double mean = glm::dot(Vec3d(light.intensity), Vec3d(1.0)) / 3.0;
            total += mean * falloff<double>(distance2, 0.0);
            EXPECT_GT(std::sqrt(distance2), 1.3) << "outside the mesh";
        }
        // The key is a little warmer than mean 1.
        EXPECT_NEAR(total, kPi, 0.06 * kPi) << count;
    }
}

}  // namespace
}  // namespace fbrdf::scene
