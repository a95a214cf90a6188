// OtherToolsTest.cpp - other tools open what is in a .fbrdf.
#include "io/TestMaterials.h"
#include "support/FileBytes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>
#include <OpenImageIO/imageio.h>

using namespace fbrdf;

namespace {

// OpenImageIO stands for every other tool: it reads through OpenEXR's C++ library.
TEST(ExrMaterial, OtherToolsOpenIt)
{
    const test::TemporaryDir folder;
    const std::string path = folder.file("m.exr");
    const Material material = test::testMaterial(formPqpr(8, 0.5, 5), Storage::half);
    test::putFile(path, materialFileBytes(material));
    const auto input = OIIO::ImageInput::open(path);
    ASSERT_TRUE(input) << OIIO::geterror();
    for (int k = 0; k < 3; ++k) {
        const Table& table = material.tables[static_cast<size_t>(k)];
        ASSERT_TRUE(input->seek_subimage(k, 0)) << input->geterror();
        const OIIO::ImageSpec spec = input->spec();
        EXPECT_EQ(spec.width, domainSize(table.domain)[0]);
        EXPECT_EQ(spec.nchannels, table.channels);
        EXPECT_EQ(spec.format, OIIO::TypeHalf);
        EXPECT_EQ(spec.get_string_attribute("fbrdf:storage"), "half");
        std::vector<float> pixels(table.texels.size());
        ASSERT_TRUE(input->read_image(k, 0, 0, spec.nchannels, OIIO::TypeFloat, pixels.data()))
            << input->geterror();
        EXPECT_EQ(pixels, table.texels) << "table " << k;
    }
    EXPECT_FALSE(input->seek_subimage(3, 0));
    ASSERT_TRUE(input->seek_subimage(0, 0));
    EXPECT_EQ(input->spec().get_int_attribute("fbrdf:version"), 1);
    EXPECT_EQ(input->spec().get_string_attribute("fbrdf:units"), "1/sr");
    EXPECT_EQ(input->spec().get_string_attribute("fbrdf:note:source"), "fixed\nsequence ä");
}

}  // namespace
