// DocumentTest.cpp - what can be changed in the window, as a value and as JSON.
#include "SampleDocument.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/scene/DocumentJson.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace fbrdf::scene {
namespace {

using Json = nlohmann::json;

/// What is said about a JSON that is not accepted.
std::string refusal(const std::string& text)
{
    try {
        documentFromJson(text, "s.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        return error.what();
    }
    return "";
}

std::string changed(const char* field, const Json& value)
{
    Json json = Json::parse(documentToJson(sampleDocument()));
    json[Json::json_pointer(field)] = value;
    return json.dump();
}

TEST(Document, EqualsItselfAndNothingElse)
{
    EXPECT_TRUE(sampleDocument() == sampleDocument());
    const Json sample = Json::parse(documentToJson(sampleDocument()));
    const Json plain = Json::parse(documentToJson(Document()));
    // Each field alone makes another document.
    for (const auto& [name, value] : plain.items()) {
        if (name == "fbrdf_scene" || name == "materials" || name == "environment") continue;
        Json json = sample;
        json[name] = value;
        EXPECT_FALSE(documentFromJson(json.dump(), "s.json") == sampleDocument()) << name;
    }
    Document moved = sampleDocument();
    moved.lights.list.areaLights[1].axisU.x = 0.6f;
    EXPECT_FALSE(moved == sampleDocument());
    moved = sampleDocument();
    moved.lights.list.lights[0].radius = 0.0f;
    EXPECT_FALSE(moved == sampleDocument());
    moved = sampleDocument();
    moved.materials[0].slot = 3;
    EXPECT_TRUE(moved == sampleDocument()) << "where it is loaded is no part of it";
}

TEST(DocumentJson, GivesBackEveryField)
{
    Document document = sampleDocument();
    EXPECT_TRUE(documentFromJson(documentToJson(document), "s.json") == document);
    document.lights = {4096, 7, {}};
    document.background = {false, Vec3f(0.1f, 0.2f, 1.0f / 3.0f)};
    document.shown = -1;
    EXPECT_TRUE(documentFromJson(documentToJson(document), "s.json") == document);
    EXPECT_TRUE(documentFromJson(documentToJson(Document()), "s.json") == Document());
}

TEST(DocumentJson, WhatIsLeftOutIsAsInADocument)
{
    EXPECT_TRUE(documentFromJson(R"({"fbrdf_scene": 1})", "s.json") == Document());
}

TEST(DocumentJson, FloatsHaveFewDigits)
{
    Document document;
    document.exposure = 0.6f;
    EXPECT_NE(documentToJson(document).find("\"exposure\": 0.6,"), std::string::npos);
}

TEST(DocumentJson, EveryPrefixIsRefused)
{
    const std::string text = documentToJson(sampleDocument());
    const size_t end = text.rfind('}');
    for (size_t length = 0; length <= end; ++length)
        ASSERT_NE(refusal(text.substr(0, length)), "") << length;
    EXPECT_EQ(refusal(text.substr(0, end + 1)), "");
}

TEST(DocumentJson, AnUnknownFieldIsNamed)
{
    for (const char* field : {"/camara", "/camera/fov", "/materials/1/alpha", "/limits/passes",
                              "/environment/rotation"}) {
        const std::string name = std::string(field).substr(std::string(field).rfind('/') + 1);
        const std::string said = refusal(changed(field, 1));
        EXPECT_NE(said.find(name), std::string::npos) << said;
        EXPECT_NE(said.find("expected one of "), std::string::npos) << said;
        EXPECT_EQ(said.find("s.json: "), 0u) << said;
    }
}

TEST(DocumentJson, AWrongValueIsNamedWithItsPlace)
{
    const struct {
        const char* field;
        Json value;
        const char* said;
    } cases[] = {
        {"/fbrdf_scene", 2, "s.json: fbrdf_scene: found 2, expected 1"},
        {"/exposure", -1, "s.json: exposure: found -1, expected a number from 1e-09"},
        {"/exposure", "bright", "exposure: found \"bright\""},
        {"/samples", 1.5, "samples: found 1.5, expected a whole number"},
        {"/samples", 0, "samples: found 0"},
        {"/shown", 2, "shown: found 2, expected a number from -1 to 1"},
        {"/mesh", 3, "mesh: found 3, expected a text"},
        {"/turning", 1, "turning: found 1, expected true or false"},
        {"/materials", "paint", "materials: found \"paint\", expected an array"},
        {"/materials/1/source", "", "s.json: materials[1].source: found none"},
        {"/materials/1/smoothness", 0, "materials[1].smoothness: found 0"},
        {"/camera/eye", {0.0, 0.3, 0.0}, "camera: found an eye that is the centre"},
        {"/camera/eye", {0, 1}, "camera.eye: found [0,1], expected an array of three"},
        {"/camera/fovy_degrees", 180, "camera.fovy_degrees: found 180"},
        {"/technique", "fast", "s.json: technique: found 'fast', expected one of single"},
        {"/look_up", "disc", "look_up: found 'disc'"},
        {"/background", {-1, 0, 0}, "background: found [-1,0,0]"},
        {"/background", "sky", "background: found \"sky\""},
        {"/environment/name", "", "background: found environment without one"},
        {"/environment/intensity", -0.5, "environment.intensity: found -0.5"},
        {"/lights", 5, "lights: found 5, expected an object"},
        {"/lights", {{"made", 70000}}, "lights.made: found 70000"},
        {"/lights/0/intensity", {1, 2}, "lights[0].intensity: found [1,2]"},
        {"/lights/3/size", 0, "lights[3].size: found 0"},
        {"/size", {0, 480}, "size: found [0,480]"},
        {"/size", {640, 480.5}, "size: found [640,480.5]"},
        {"/target", "RGBA16", "target: found \"RGBA16\", expected \"RGBA32F\""},
        {"/table_degrees", 1e300, "table_degrees: found 1e+300"},
        {"/compare", "on", "compare: found \"on\", expected an object"},
        {"/compare/mode", "blend", "s.json: compare.mode: found 'blend', expected one of split"},
        {"/compare/at", 1.5, "compare.at: found 1.5, expected a number from 0 to 1"},
        {"/compare/gain", 0.5, "compare.gain: found 0.5"},
    };
    for (const auto& c : cases) {
        const std::string said = refusal(changed(c.field, c.value));
        EXPECT_NE(said.find(c.said), std::string::npos) << c.field << ": " << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
}

TEST(DocumentJson, NumbersThatNoDoubleHasAreRefused)
{
    for (const char* text :
         {R"({"fbrdf_scene": 1, "exposure": 1e999})", R"({"fbrdf_scene": 1, "exposure": NaN})",
          R"({"fbrdf_scene": 1, "samples": 99999999999999999999})",
          R"({"fbrdf_scene": 1, "size": [4294967297, 1]})", R"({"fbrdf_scene": 1e0001, "x)", "[]",
          "7", ""})
        EXPECT_NE(refusal(text), "") << text;
    const std::string deep(100000, '[');
    EXPECT_NE(refusal(deep), "");
}

TEST(DocumentJson, NamesThatAreNoTextCannotBeWritten)
{
    Document document;
    document.mesh = "\xff.obj";
    try {
        documentToJson(document);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::output);
    }
}

TEST(Document, MadeLightsFollowTheirNumberAndSeed)
{
    const Bounds bounds{Vec3f(0.0f), 1.0f};
    EXPECT_EQ(lightsOf({12, 3, {}}, bounds).lights.size(), 12u);
    EXPECT_TRUE(lightsOf({12, 3, {}}, bounds) == lightsOf({12, 3, {}}, bounds));
    EXPECT_FALSE(lightsOf({12, 3, {}}, bounds) == lightsOf({12, 4, {}}, bounds));
    EXPECT_TRUE(lightsOf({0, 3, oneLightOfEachKind()}, bounds) == oneLightOfEachKind());
}

}  // namespace
}  // namespace fbrdf::scene
