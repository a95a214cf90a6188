// Readers and writers under a locale whose decimal sign is a comma and that groups thousands.
#include "ReaderTest.h"
#include "support/CommaLocale.h"

#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/Model.h>
#include <fbrdf/sources/Write.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

std::string textOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Material paint()
{
    Material material;
    material.name = "paint";
    material.form = formPqp(8, 0.5);
    for (const TableSpec& spec : material.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        for (int i = 0; i < 3 * texelCount(spec.domain); ++i)
            table.texels.push_back(0.125f + 0.0625f * float(i % 7));
        material.tables.push_back(table);
    }
    material.scales = {Vec3f(0.5f, 1.25f, 1234.5f)};
    material.errors["log_rms"] = 0.12345;
    return material;
}

/// What was read and written, as text.
struct Results {
    std::string samples, csv, manifest, message, description;
};

Results resultsOf(const TempFolder& folder)
{
    Results results;
    const Source csv = openSource(folder.write(
        "a.csv",
        "theta_i,phi_i,theta_o,phi_o,value\n30.5,0.25,60.125,180,0.37\n10,0,20,0,1234.5\n"));
    writeCsv(csv, folder.path("b.csv"));
    results.csv = textOf(folder.path("b.csv"));
    const Source cornell =
        openSource(folder.write("a.brdf", "2\n450.5 650.25\n0.5 0.0 0.25 3.1415 0.1 0.2\n"));
    writeCsv(cornell, folder.path("c.csv"));
    results.samples = textOf(folder.path("c.csv"));
    writeMaterial(paint(), folder.path("m.json"));
    results.manifest = textOf(folder.path("m.json"));
    results.description = describe(readMaterial(folder.path("m.json")).form) +
                          openSource("ggx:alpha=0.25,f0=0.04/0.5/1").description;
    results.message = outcomeOf(folder.write("d.brdf", "2\n0.45 650.25\n0 0 0 0 1 1\n")).message;
    return results;
}

}  // namespace

TEST(Locale, ReadersAndWritersDoNotSeeIt)
{
    const TempFolder folder;
    const Results before = resultsOf(folder);
    ASSERT_NE(before.csv.find("0.37"), std::string::npos);
    const CommaLocale comma;
    const Results after = resultsOf(folder);
    EXPECT_EQ(after.csv, before.csv);
    EXPECT_EQ(after.samples, before.samples);
    EXPECT_EQ(after.manifest, before.manifest);
    EXPECT_EQ(after.description, before.description);
    EXPECT_EQ(after.message, before.message);
}
