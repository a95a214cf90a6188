// MarksTest.cpp - marks of texels that no sample supports go through every format that has them.
#include "Codes.h"
#include "io/TestMaterials.h"
#include "support/ExpectError.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/FormFile.h>
#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace fbrdf;
using fbrdf::test::expectError;
using fbrdf::test::TemporaryDir;

namespace {

Material markedMaterial()
{
    Material material = test::testMaterial(formHdio({7, 4, 6}), Storage::log8);
    auto& marks = material.tables[1].unsupported;
    marks.assign(36, false);
    marks[0] = marks[5] = marks[6] = marks[35] = true;
    return material;
}

TEST(Marks, GoThroughFilesAndConversions)
{
    const TemporaryDir folder;
    const Material material = markedMaterial();
    writeMaterial(material, folder.file("a.fbrdf"));
    writeMaterial(readMaterial(folder.file("a.fbrdf")), folder.file("b.json"));
    writeMaterial(readMaterial(folder.file("b.json")), folder.file("c.fbrdf"));
    for (const char* name : {"a.fbrdf", "b.json", "c.fbrdf"}) {
        const Material back = readMaterial(folder.file(name));
        EXPECT_TRUE(back.tables[0].unsupported.empty()) << name << ": nothing was known of it";
        EXPECT_EQ(back.tables[1].unsupported, material.tables[1].unsupported) << name;
    }
}

TEST(Marks, RunsComeBack)
{
    for (const std::vector<bool>& marks :
         {std::vector<bool>{true}, {false}, {true, true, false}, {false, true, false, true}})
        EXPECT_EQ(marksFromRuns(runsOfMarks(marks), static_cast<int>(marks.size()), "x"), marks);
    EXPECT_EQ(runsOfMarks({false, true, true}), "1 2");
}

TEST(Marks, RunsThatDoNotFitAreRefused)
{
    for (const char* runs : {"", "3", "5", "2 3", "x", "2 x", "-1 5", "2,2",
                             "99999999999999999999999", "18446744073709551615 5"})
        expectError(ErrorKind::input, "", [&] { marksFromRuns(runs, 4, "x"); });
    Material material = markedMaterial();
    material.tables[1].unsupported.pop_back();
    expectError(ErrorKind::input, "", [&] { validate(material, "x"); });
}

TEST(FormFile, ReadsAFormAndTheFormOfAManifest)
{
    const TemporaryDir folder;
    const Material material = markedMaterial();
    writeMaterial(material, folder.file("m.json"));
    EXPECT_EQ(describe(readForm(folder.file("m.json"))), describe(material.form));
    std::ofstream(folder.file("f.json"))
        << R"({"name": "q", "tables": [{"name": "q", "domain": {"disc": {"size": 8, "gamma": 0.5,
               "radius": 3.5}}}], "terms": [[{"table": 0, "argument": "h"}]]})";
    EXPECT_EQ(describe(readForm(folder.file("f.json"))), "q[disc 8x8 gamma 0.5](h)");
    std::ofstream(folder.file("bad.json")) << R"({"name": "q", "tables": [], "terms": []})";
    expectError(ErrorKind::input, "", [&] { readForm(folder.file("bad.json")); });
    expectError(ErrorKind::input, "", [&] { readForm(folder.file("none.json")); });
}

TEST(FormFile, MakesAFormFromTextInMemory)
{
    const Form form = formFromJson(
        R"({"name": "q", "tables": [{"name": "q", "domain": {"disc": {"size": 8, "gamma": 0.5,
            "radius": 3.5}}}], "terms": [[{"table": 0, "argument": "h"}]]})");
    EXPECT_EQ(describe(form), "q[disc 8x8 gamma 0.5](h)");
    const char* unknown = R"({"name": "q", "tables": [{"name": "q", "domain": {"grid":
        {"symmetric": false, "axes": [{"size": 4, "from": "cos", "exponent": 1}]}}}],
        "terms": [[{"table": 0, "argument": ["theta_x"]}]]})";
    expectError(ErrorKind::input, "scene 7: /terms/0/0/argument/0: found \"theta_x\"",
                [&] { formFromJson(unknown, "scene 7"); });
    expectError(ErrorKind::input, "scene 7: byte 2: found text that is not JSON",
                [] { formFromJson("{", "scene 7"); });
}

}  // namespace
