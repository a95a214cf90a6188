#include "JsonFields.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/DocumentJson.h>

#include <cmath>
#include <limits>

namespace fbrdf::scene {
namespace {

constexpr int kVersion = 1;
constexpr int kMostMaterials = 1000, kMostTexels = 4096, kMostKilobytes = 1 << 20;
constexpr int kLargestPicture = 16384;  // as --size
constexpr double kLargest = 1e9;        // of factors and degrees: far more than anybody means
constexpr double kSmallest = 1e-9;      // of factors that must not be 0
constexpr Interval kAnyDegrees{-kLargest, kLargest};

/// A name that one of the project's functions knows: their errors are of usage, as for an option.
template <class Read>
auto named(JsonFields& fields, const char* name, const Read& read) -> decltype(read(""))
{
    std::string text;
    fields.read(name, text);
    try {
        return read(text);
    } catch (const Error& error) {
        const std::string sentence = error.what();
        const size_t what = sentence.find("found ");
        failLight(fields.place(name), what == std::string::npos ? sentence : sentence.substr(what));
    }
}

SceneMaterial materialFrom(const Json& json, const std::string& where)
{
    JsonFields fields(json, where);
    SceneMaterial material;
    fields.read("source", material.source);
    if (material.source.empty())
        failLight(fields.place("source"), Found("none").expected("a file or a model"));
    fields.read("form", material.form);
    fields.read("resolution", material.resolution, {0, kMostTexels});
    fields.read("kilobytes", material.kilobytes, {0, kMostKilobytes});
    double smoothness = 0.0;
    fields.read("smoothness", smoothness, {1e-12, 1e6});
    if (smoothness > 0.0) material.smoothness = smoothness;
    fields.expectNoOthers();
    return material;
}

Json jsonFrom(const SceneMaterial& material)
{
    Json json{{"source", material.source}};
    if (material.form != SceneMaterial().form) json["form"] = material.form;
    if (material.resolution > 0) json["resolution"] = material.resolution;
    if (material.kilobytes > 0) json["kilobytes"] = material.kilobytes;
    if (material.smoothness) json["smoothness"] = *material.smoothness;
    return json;
}

std::vector<SceneMaterial> materialsFrom(const Json& list, const std::string& where)
{
    if (!list.is_array() || list.size() > kMostMaterials)
        failLight(where, Found(quoted(list)).expected("an array of up to 1000 materials"));
    std::vector<SceneMaterial> materials;
    for (const Json& material : list)
        materials.push_back(
            materialFrom(material, where + "[" + std::to_string(materials.size()) + "]"));
    return materials;
}

SceneLights sceneLightsFrom(const Json& json, const std::string& where)
{
    SceneLights lights;
    if (json.is_array()) {
        lights.list = lightsFromList(json, where);
        return lights;
    }
    JsonFields fields(json, where);
    double seed = 0.0;
    fields.read("made", lights.made, {0, kMostLights});
    fields.read("seed", seed, {0, std::numeric_limits<uint32_t>::max()});
    lights.seed = static_cast<uint32_t>(seed);
    fields.expectNoOthers();
    return lights;
}

Json jsonFrom(const SceneLights& lights)
{
    if (lights.made == 0) return listFromLights(lights.list);
    return {{"made", lights.made}, {"seed", lights.seed}};
}

SceneEnvironment environmentFrom(const Json& json, const std::string& where)
{
    JsonFields fields(json, where);
    SceneEnvironment environment;
    fields.read("name", environment.name);
    fields.read("rotation_degrees", environment.degrees, kAnyDegrees);
    fields.read("intensity", environment.intensity, {0.0, kLargest});
    fields.read("lobes", environment.lobes, {0, kMostTiltedLobes});
    fields.read("samples", environment.samples, {0, kMostSamples});
    fields.expectNoOthers();
    return environment;
}

Json jsonFrom(const SceneEnvironment& environment)
{
    return {{"name", environment.name},
            {"rotation_degrees", jsonFromFloat(environment.degrees)},
            {"intensity", jsonFromFloat(environment.intensity)},
            {"lobes", environment.lobes},
            {"samples", environment.samples}};
}

Camera cameraFrom(const Json& json, const std::string& where)
{
    JsonFields fields(json, where);
    Camera camera;
    double degrees = camera.fovy / kDegree;
    fields.read("eye", camera.eye);
    fields.read("centre", camera.centre);
    fields.read("fovy_degrees", degrees, {1e-3, 179.999});
    fields.expectNoOthers();
    if (camera.eye == camera.centre)
        failLight(where, Found("an eye that is the centre").expected("two different points"));
    if (degrees != camera.fovy / kDegree) camera.fovy = degrees * kDegree;
    return camera;
}

Json jsonFrom(const Vec3d& v)
{
    return Json::array({v.x, v.y, v.z});
}

Json jsonFrom(const Camera& camera)
{
    return {{"eye", jsonFrom(camera.eye)},
            {"centre", jsonFrom(camera.centre)},
            {"fovy_degrees", camera.fovy / kDegree}};
}

Background backgroundFrom(const Json& json, const std::string& where)
{
    Background background;
    if (json == "environment") {
        background.environment = true;
    } else if (json.is_array()) {
        background.colour = vectorFrom(json, where);
        for (int k = 0; k < 3; ++k)
            if ((*background.colour)[k] < 0.0f)
                failLight(where, Found(quoted(json)).expected("three numbers >= 0"));
    } else if (json != "none") {
        failLight(
            where,
            Found(quoted(json)).expected("\"environment\", \"none\" or an array of three numbers"));
    }
    return background;
}

Json jsonFrom(const Background& background)
{
    if (background.colour) return jsonFromVector(*background.colour);
    return background.environment ? "environment" : "none";
}

DrawLimits limitsFrom(const Json& json, const std::string& where)
{
    JsonFields fields(json, where);
    DrawLimits limits;
    fields.read("lookups", limits.lookups, {0, 1000});
    fields.read("lights", limits.lights, {0, kMostLights});
    fields.read("lights_per_pass", limits.lightsPerPass, {1, kMostLights});
    fields.expectNoOthers();
    return limits;
}

Json jsonFrom(const DrawLimits& limits)
{
    return {{"lookups", limits.lookups},
            {"lights", limits.lights},
            {"lights_per_pass", limits.lightsPerPass}};
}

Comparison comparisonFrom(const Json& json, const std::string& where)
{
    JsonFields fields(json, where);
    Comparison compare;
    fields.read("on", compare.on);
    if (fields.field("mode")) compare.mode = named(fields, "mode", compareModeFromName);
    fields.read("a", compare.a);
    fields.read("b", compare.b);
    fields.read("at", compare.at, {0.0, 1.0});
    fields.read("gain", compare.gain, {kLeastGain, kMostGain});
    fields.read("holds", compare.holds);
    fields.expectNoOthers();
    return compare;
}

Json jsonFrom(const Comparison& compare)
{
    return {{"on", compare.on},
            {"mode", compareModeName(compare.mode)},
            {"a", compare.a},
            {"b", compare.b},
            {"at", jsonFromFloat(compare.at)},
            {"gain", jsonFromFloat(compare.gain)},
            {"holds", compare.holds}};
}

ColourFormat targetFrom(const Json& json, const std::string& where)
{
    for (const ColourFormat format :
         {ColourFormat::rgba32f, ColourFormat::rgba16f, ColourFormat::rgba8})
        if (json == colourFormatName(format)) return format;
    failLight(where, Found(quoted(json)).expected("\"RGBA32F\", \"RGBA16F\" or \"RGBA8\""));
}

void readSize(JsonFields& fields, Moment& moment)
{
    const Json* const size = fields.field("size");
    if (!size) return;
    const auto isSide = [](const Json& side) {
        return side.is_number_integer() && side >= 1 && side <= kLargestPicture;
    };
    if (!size->is_array() || size->size() != 2 || !isSide((*size)[0]) || !isSide((*size)[1]))
        failLight(fields.place("size"),
                  Found(quoted(*size)).expected("width and height of 1 to 16384 pixels"));
    moment.width = (*size)[0].get<int>();
    moment.height = (*size)[1].get<int>();
}

/// What is drawn and lit.
void readContent(JsonFields& fields, Document& document)
{
    if (const Json* list = fields.field("materials"))
        document.materials = materialsFrom(*list, fields.place("materials"));
    fields.read("shown", document.shown, {-1, static_cast<double>(document.materials.size()) - 1});
    fields.read("mesh", document.mesh);
    if (const Json* lights = fields.field("lights"))
        document.lights = sceneLightsFrom(*lights, fields.place("lights"));
    if (const Json* environment = fields.field("environment"))
        document.environment = environmentFrom(*environment, fields.place("environment"));
    if (const Json* background = fields.field("background"))
        document.background = backgroundFrom(*background, fields.place("background"));
    if (document.background.environment && document.environment.name.empty())
        failLight(fields.place("background"),
                  Found("environment without one").expected("an environment with a name"));
    fields.read("ground", document.ground);
    fields.read("shadows", document.shadows);
}

/// How it is drawn, and from where.
void readPicture(JsonFields& fields, Document& document)
{
    if (const Json* camera = fields.field("camera"))
        document.camera = cameraFrom(*camera, fields.place("camera"));
    if (fields.field("technique"))
        document.technique = named(fields, "technique", viewTechniqueFromName);
    if (fields.field("look_up")) document.lookUp = named(fields, "look_up", lookUpFromName);
    fields.read("precise", document.precise);
    if (const Json* limits = fields.field("limits"))
        document.limits = limitsFrom(*limits, fields.place("limits"));
    if (const Json* target = fields.field("target"))
        document.target = targetFrom(*target, fields.place("target"));
    fields.read("tone_map", document.toneMap);
    fields.read("samples", document.samples, {1, kMostSamples});
    fields.read("path_samples", document.pathSamples, {1, kMostSamples});
    fields.read("spread", document.spread);
    fields.read("exposure", document.exposure, {kSmallest, kLargest});
    fields.read("turning", document.turning);
    fields.read("orbiting", document.orbiting);
    if (const Json* compare = fields.field("compare"))
        document.compare = comparisonFrom(*compare, fields.place("compare"));
    fields.read("table_degrees", document.moment.tableDegrees, kAnyDegrees);
    fields.read("lights_degrees", document.moment.lightsDegrees, kAnyDegrees);
    readSize(fields, document.moment);
}

Json parsedJson(std::string_view text, const std::string& where)
{
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        failLight(where, Found(error.what()).expected("JSON {\"fbrdf_scene\": 1, ...}"));
    }
}

}  // namespace

Document documentFromJson(std::string_view text, const std::string& where)
{
    const Json json = parsedJson(text, where);
    JsonFields fields(json, where);
    const Json* const version = fields.field("fbrdf_scene");
    if (!version || *version != kVersion)
        failLight(fields.place("fbrdf_scene"),
                  Found(version ? quoted(*version) : "none").expected("1, the version of scenes"));
    Document document;
    readContent(fields, document);
    readPicture(fields, document);
    fields.expectNoOthers();
    return document;
}

std::string documentToJson(const Document& document)
{
    Json json{{"fbrdf_scene", kVersion},
              {"materials", Json::array()},
              {"shown", document.shown},
              {"mesh", document.mesh},
              {"lights", jsonFrom(document.lights)},
              {"environment", jsonFrom(document.environment)},
              {"background", jsonFrom(document.background)},
              {"ground", document.ground},
              {"shadows", document.shadows},
              {"technique", viewTechniqueName(document.technique)},
              {"look_up", lookUpName(document.lookUp)},
              {"precise", document.precise},
              {"limits", jsonFrom(document.limits)},
              {"target", colourFormatName(document.target)},
              {"tone_map", document.toneMap},
              {"samples", document.samples},
              {"path_samples", document.pathSamples},
              {"spread", document.spread},
              {"exposure", jsonFromFloat(document.exposure)},
              {"turning", document.turning},
              {"orbiting", document.orbiting},
              {"compare", jsonFrom(document.compare)},
              {"table_degrees", document.moment.tableDegrees},
              {"lights_degrees", document.moment.lightsDegrees}};
    for (const SceneMaterial& material : document.materials)
        json["materials"].push_back(jsonFrom(material));
    if (document.camera) json["camera"] = jsonFrom(*document.camera);
    if (document.moment.width > 0) json["size"] = {document.moment.width, document.moment.height};
    try {
        return json.dump(2) + "\n";
    } catch (const Json::exception&) {
        throw Error(ErrorKind::output, "scene",
                    Found("a name of bytes that are no UTF-8").expected("names of files in UTF-8"));
    }
}

}  // namespace fbrdf::scene
