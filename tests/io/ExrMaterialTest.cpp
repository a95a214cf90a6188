// ExrMaterialTest.cpp - the .fbrdf file as a format: what goes in comes out, the same bytes every
// time, other tools read it. Hostile input is in HostileFileTest.cpp.
#include "io/FileBytes.h"
#include "io/TestMaterials.h"
#include "support/TemporaryDir.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

using namespace fbrdf;
using fbrdf::test::TemporaryDir;

namespace {

TEST(ExrMaterial, RoundTripsEveryFormAndStorageBitForBit)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    for (const Form& form : test::testForms())
        for (const Storage storage : test::kStorages) {
            const Material material = test::testMaterial(form, storage);
            writeMaterial(material, path);
            EXPECT_TRUE(isMaterialFile(path));
            EXPECT_EQ(test::firstDifference(readMaterial(path), material), "")
                << form.name << " " << storageName(storage);
        }
}

TEST(ExrMaterial, ComparisonSeesASingleBit)  // the tester itself
{
    const Material a = test::testMaterial(formPqp(9, 0.5), Storage::float32);
    Material b = a;
    b.tables[1].texels[7] = std::nextafter(b.tables[1].texels[7], 100.0f);
    EXPECT_EQ(test::firstDifference(a, b), "texels of table 1");
    b = a;
    b.form.terms[0].factors[0].argument = Direction::h;
    EXPECT_EQ(test::firstDifference(a, b), "form");
}

}  // namespace
