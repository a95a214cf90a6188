// ModelSpecTest.cpp - specifications of models: what is accepted, and the text of each error.
#include <models/NearestName.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <random>

namespace fbrdf::test {
namespace {

/// The message of the Error(usage) that a specification throws; "" when it throws none.
std::string messageOf(const std::string& spec)
{
    try {
        makeModelSource(spec);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage) << spec;
        return error.what();
    }
    return "";
}

#define EXPECT_SAYS(spec, part) \
    EXPECT_NE(messageOf(spec).find(part), std::string::npos) << spec << " says: " << messageOf(spec)

TEST(ModelSpec, NameAloneMeansDefaults)
{
    const ModelSpec spec = parseModelSpec("phong");
    EXPECT_EQ(spec.model, findModel("phong"));
    EXPECT_EQ(spec.values.at("kd"), Vec3d(0.3));
    EXPECT_EQ(spec.values.at("n"), Vec3d(50.0));
    EXPECT_EQ(spec.values.size(), 3u);
}

TEST(ModelSpec, ReadsScalarsColoursAndGreys)
{
    const ModelValues values =
        parseModelSpec("ggx:f0=0.9/0.7/.3,kd=0.25,alpha_x=1e-2, alpha_y = 0.5").values;
    EXPECT_EQ(values.at("f0"), Vec3d(0.9, 0.7, 0.3));
    EXPECT_EQ(values.at("kd"), Vec3d(0.25));
    EXPECT_EQ(values.at("alpha_x").x, 0.01);
    EXPECT_EQ(values.at("alpha_y").x, 0.5);
}

TEST(ModelSpec, ShorthandSetsBothRoughnesses)
{
    for (const char* name : {"ggx:alpha=0.3", "beckmann:alpha=0.3", "ward:alpha=0.3"}) {
        const ModelValues values = parseModelSpec(name).values;
        EXPECT_EQ(values.at("alpha_x").x, 0.3) << name;
        EXPECT_EQ(values.at("alpha_y").x, 0.3) << name;
        EXPECT_EQ(values.count("alpha"), 0u) << name;
    }
}

TEST(ModelSpec, FixedNamesAndParametersExist)
{
    for (const char* spec :
         {"lambert:albedo=0.5", "phong:kd=0.2,ks=0.3,n=10", "blinn-phong:kd=0.2,ks=0.3,n=10",
          "lafortune:kd=0.1,cx=-1,cy=-1,cz=1,n=5",
          "ward:rho_d=0.1,rho_s=0.2,alpha_x=0.1,alpha_y=0.2", "ward-rolled-brass",
          "ward-brushed-aluminium", "ashikhmin-shirley:kd=0.1,ks=0.2,nu=10,nv=20",
          "ggx:alpha=0.1,f0=0.04,kd=0.3", "ggx:alpha_x=0.1,alpha_y=0.4,f0=0.9,kd=0",
          "beckmann:alpha=0.1,f0=0.04,kd=0.3", "oren-nayar:albedo=0.5,sigma=0.3",
          "poulin-fournier:kd=0.1,ks=0.5,n=50,height=0.5,spacing=1.5"})
        EXPECT_EQ(messageOf(spec), "") << spec;
}

// Of every model and preset, with values that need all digits.
TEST(ModelSpec, ComesBackFromItsText)
{
    std::vector<std::string> names;
    for (const Model& model : models()) names.push_back(model.name);
    for (const ModelPreset& preset : modelPresets()) names.push_back(preset.name);
    for (const std::string& name : names) {
        ModelSpec spec = parseModelSpec(name);
        for (const ModelParameter& parameter : spec.model->parameters) {
            if (parameter.kind != ModelParameter::Kind::colour) continue;
            const double middle = 0.5 * (parameter.lower + parameter.upper);
            spec.values[parameter.name] = {parameter.lower, middle / 3.0, middle};
        }
        const ModelSpec again = parseModelSpec(modelSpecText(spec));
        EXPECT_EQ(again.model, spec.model) << name;
        EXPECT_EQ(again.values, spec.values) << modelSpecText(spec);
    }
}

TEST(ModelSpec, SourceDescribesItself)
{
    const Source source = makeModelSource("ggx:alpha=0.2");
    EXPECT_EQ(source.name, "ggx:alpha=0.2");
    EXPECT_EQ(source.format, "model");
    EXPECT_NE(source.description.find("Walter"), std::string::npos);
    EXPECT_TRUE(source.samples.empty());
    EXPECT_EQ(source.report.given, 0u);
}

TEST(ModelSpec, UnknownModelNamesTheNearest)
{
    EXPECT_SAYS("gxx", "found 'gxx'");
    EXPECT_SAYS("gxx", "did you mean 'ggx'?");
    EXPECT_SAYS("ashikmin-shirley:nu=3", "did you mean 'ashikhmin-shirley'?");
    EXPECT_SAYS("ward-roled-brass", "did you mean 'ward-rolled-brass'?");
    EXPECT_SAYS("completely-else", "expected a file that exists or a model");
    EXPECT_EQ(messageOf("completely-else").find("did you mean"), std::string::npos);
    EXPECT_SAYS("", "found ''");
    EXPECT_SAYS("GGX", "did you mean 'ggx'?");
}

TEST(ModelSpec, UnknownKeyNamesTheNearestAndAll)
{
    EXPECT_SAYS("ggx:alfa=0.1", "model ggx: found the parameter 'alfa'");
    EXPECT_SAYS("ggx:alfa=0.1", "did you mean 'alpha'?");
    EXPECT_SAYS("ggx:alfa=0.1", "alpha_x, alpha_y");
    EXPECT_SAYS("lambert:kd=0.1", "expected one of albedo");
    EXPECT_SAYS("ggx:=0.1", "found the parameter ''");
}

TEST(ModelSpec, MissingAssignmentIsNamed)
{
    EXPECT_SAYS("ggx:alpha", "found 'alpha', expected key=value");
    EXPECT_SAYS("ggx:", "found '', expected key=value");
    EXPECT_SAYS("ggx:alpha=0.1,", "found '', expected key=value");
    EXPECT_SAYS("ggx:,alpha=0.1", "found '', expected key=value");
}

TEST(ModelSpec, MalformedNumbersAreNamed)
{
    EXPECT_SAYS("ggx:alpha=", "alpha='', expected a number");
    EXPECT_SAYS("ggx:alpha=abc", "alpha='abc', expected a number");
    EXPECT_SAYS("ggx:alpha=0.1x", "alpha='0.1x', expected a number");
    EXPECT_SAYS("ggx:alpha=0.1=0.2", "alpha='0.1=0.2', expected a number");
    EXPECT_SAYS("ggx:f0=0.1//0.2", "f0='', expected a number");
}

TEST(ModelSpec, NumberOfComponentsIsChecked)
{
    EXPECT_SAYS("ggx:alpha=0.1/0.2/0.3", "alpha='0.1/0.2/0.3', expected one number");
    EXPECT_SAYS("phong:n=1/2/3", "n='1/2/3', expected one number");
    EXPECT_SAYS("ggx:f0=0.1/0.2", "f0='0.1/0.2', expected one number or r/g/b");
    EXPECT_SAYS("ggx:f0=0.1/0.2/0.3/0.4", "expected one number or r/g/b");
}

TEST(ModelSpec, RangesAreCheckedAtBothEndsAndForEachComponent)
{
    EXPECT_SAYS("ggx:alpha=0", "alpha=0, expected 0.0001 to 2");
    EXPECT_SAYS("ggx:alpha=2.1", "alpha=2.1, expected 0.0001 to 2");
    EXPECT_SAYS("ggx:f0=0.1/0.2/1.5", "f0=1.5, expected 0 to 1");
    EXPECT_SAYS("lambert:albedo=-0.1", "albedo=-0.1, expected 0 to 1");
    EXPECT_SAYS("oren-nayar:sigma=30", "sigma=30, expected 0 to 1.57");
    EXPECT_SAYS("phong:n=nan", "n=nan, expected 0 to 1000000");
    EXPECT_SAYS("phong:n=inf", "n=inf, expected 0 to 1000000");
    EXPECT_SAYS("phong:n=1e999", "expected 0 to 1000000");
    EXPECT_EQ(messageOf("ggx:alpha=2"), "");
    EXPECT_EQ(messageOf("ggx:alpha=0.0001"), "");
}

TEST(ModelSpec, SettingTwiceIsAnError)
{
    EXPECT_SAYS("phong:n=3,n=3", "found n set twice");
    EXPECT_SAYS("ggx:alpha=0.1,alpha_x=0.2", "found alpha_x set twice");
    EXPECT_SAYS("ggx:alpha_y=0.1,alpha=0.2", "found alpha_y set twice");
}

TEST(ModelSpec, SurvivesGarbage)
{
    std::mt19937 random(3);
    const std::string letters = "ggx:alpha=0.1,/ward-\n\t\xff_ek";
    for (int k = 0; k < 5000; ++k) {
        std::string spec = k % 2 ? "ggx:" : "";
        for (auto n = random() % 30; n > 0; --n) spec += letters[random() % letters.size()];
        messageOf(spec);
    }
    EXPECT_SAYS(std::string(100000, 'x'), "expected a file that exists or a model");
    EXPECT_LT(messageOf("ggx:alpha=" + std::string(100000, '1')).size(), 300u);
}

TEST(ModelSpec, NamesModelLooksAtTheNameOnly)
{
    EXPECT_TRUE(namesModel("ggx"));
    EXPECT_TRUE(namesModel("ggx:nonsense"));
    EXPECT_TRUE(namesModel("ward-rolled-brass:rho_d=0.2"));
    EXPECT_FALSE(namesModel("gold.fbrdf"));
    EXPECT_FALSE(namesModel(""));
    EXPECT_FALSE(namesModel("alpha=0.1"));
}

TEST(ModelPresets, AreTheMaterialsOfWard1992)
{
    struct Row {
        const char* name;
        double rho_d, rho_s, alpha_x, alpha_y;
    };
    for (const Row& row : {Row{"ward-rolled-brass", 0.10, 0.33, 0.050, 0.16},
                           {"ward-brushed-aluminium", 0.15, 0.19, 0.088, 0.13},
                           {"ward-lightly-brushed-aluminium", 0.15, 0.19, 0.088, 0.13},
                           {"ward-varnished-plywood", 0.33, 0.025, 0.040, 0.11},
                           {"ward-white-ceramic-tile", 0.70, 0.050, 0.071, 0.071},
                           {"ward-glossy-grey-paper", 0.29, 0.083, 0.082, 0.082},
                           {"ward-ivory-computer-plastic", 0.45, 0.043, 0.130, 0.130}}) {
        const ModelSpec spec = parseModelSpec(row.name);
        EXPECT_EQ(spec.model->name, "ward");
        EXPECT_EQ(spec.values.at("rho_d"), Vec3d(row.rho_d)) << row.name;
        EXPECT_EQ(spec.values.at("rho_s"), Vec3d(row.rho_s)) << row.name;
        EXPECT_EQ(spec.values.at("alpha_x"), Vec3d(row.alpha_x)) << row.name;
        EXPECT_EQ(spec.values.at("alpha_y"), Vec3d(row.alpha_y)) << row.name;
    }
}

TEST(ModelPresets, CanBeChangedInPart)
{
    const ModelValues values = parseModelSpec("ward-rolled-brass:rho_d=0.2").values;
    EXPECT_EQ(values.at("rho_d"), Vec3d(0.2));
    EXPECT_EQ(values.at("rho_s"), Vec3d(0.33));
}

TEST(ModelPresets, NameModelsAndParametersThatExistWithValuesInRange)
{
    for (const ModelPreset& preset : modelPresets()) {
        const Model* model = findModel(preset.model);
        ASSERT_NE(model, nullptr) << preset.name;
        EXPECT_EQ(findModel(preset.name), nullptr) << "also a model";
        const ModelValues complete = parseModelSpec(preset.model).values;
        for (const auto& [name, value] : preset.values) EXPECT_TRUE(complete.count(name)) << name;
        EXPECT_EQ(messageOf(preset.name), "");
    }
}

TEST(DescribeModels, NamesEveryModelParameterPaperAndPreset)
{
    const std::string text = describeModels();
    for (const Model& model : models()) {
        EXPECT_NE(text.find(model.name + ": "), std::string::npos) << model.name;
        EXPECT_NE(text.find(model.paper), std::string::npos) << model.name;
        for (const ModelParameter& parameter : model.parameters)
            EXPECT_NE(text.find(parameter.name), std::string::npos) << parameter.name;
    }
    for (const ModelPreset& preset : modelPresets())
        EXPECT_NE(text.find(preset.name), std::string::npos) << preset.name;
    EXPECT_NE(text.find("default 0.04"), std::string::npos);
}

TEST(NearestName, CountsEdits)
{
    EXPECT_EQ(editDistance("ward", "ward"), 0u);
    EXPECT_EQ(editDistance("", "abc"), 3u);
    EXPECT_EQ(editDistance("wrad", "ward"), 1u);  // a swap
    EXPECT_EQ(editDistance("war", "ward"), 1u);   // an insertion
    EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(NearestName, GivesNothingWhenNothingIsNear)
{
    EXPECT_EQ(nearestName("phnog", {"ggx", "phong"}), "phong");
    EXPECT_EQ(nearestName("xyz", {"ggx", "phong"}), "");
    EXPECT_EQ(nearestName("", {"ggx"}), "");
    EXPECT_EQ(suggestion("ggy", {"ggx"}), ", did you mean 'ggx'?");
}

}  // namespace
}  // namespace fbrdf::test
