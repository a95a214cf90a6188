#include "Pictures.h"

#include <fbrdf/plan/Transfer.h>

#include <gtest/gtest.h>

#include <osg/Image>
#include <osgDB/WriteFile>

#include <algorithm>
#include <cstdlib>

namespace fbrdf::test {

void keepPicture(const std::vector<float>& picture, int width, const std::string& name)
{
    const char* keep = std::getenv("FBRDF_KEEP_SCREENS");
    if (!keep) return;
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    const int height = static_cast<int>(picture.size()) / (4 * width);
    image->allocateImage(width, height, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    for (size_t pixel = 0; pixel < picture.size() / 4; ++pixel)
        for (size_t c = 0; c < 3; ++c) {
            const float code = transferred(Transfer::srgb, 1.0f, picture[4 * pixel + c]);
            image->data()[3 * pixel + c] =
                static_cast<unsigned char>(255.0f * std::clamp(code, 0.0f, 1.0f) + 0.5f);
        }
    EXPECT_TRUE(osgDB::writeImageFile(*image, keep + name + ".png"));
}

}  // namespace fbrdf::test
