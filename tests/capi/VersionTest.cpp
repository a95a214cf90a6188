// Structs of callers that were compiled against other versions of the ABI; no GL.
#include "Descriptor.h"

#include <fbrdf/fbrdf.hpp>

#include <gtest/gtest.h>

namespace fbrdf::capi {
namespace {

template <class T>
class CApiVersions : public ::testing::Test {
public:
    /// What known() makes of `size` bytes, of which number `set` is 1 and the others are 0.
    static T read(size_t size, size_t set = SIZE_MAX)
    {
        std::vector<unsigned char> bytes(size);
        if (set < size) bytes[set] = 1;
        return known<T>(bytes.data(), size, "it");
    }
    static fbrdf_result resultOf(size_t size, size_t set = SIZE_MAX)
    {
        try {
            read(size, set);
            return FBRDF_RESULT_OK;
        } catch (const Failure& failure) {
            return failure.result;
        }
    }
};

using Structs =
    ::testing::Types<fbrdf_table, fbrdf_material_desc, fbrdf_renderer_desc, fbrdf_gpu_material_desc,
                     fbrdf_mesh_desc, fbrdf_buffer_array, fbrdf_mesh_buffers_desc, fbrdf_hooks_desc,
                     fbrdf_light, fbrdf_item, fbrdf_depth_desc, fbrdf_draw_desc, fbrdf_draw_stats,
                     fbrdf_instance, fbrdf_batch_desc, fbrdf_glsl_desc, fbrdf_environment_desc,
                     fbrdf_environment_light>;
TYPED_TEST_SUITE(CApiVersions, Structs);

TYPED_TEST(CApiVersions, OlderCallersHaveZerosInWhatTheyLack)
{
    EXPECT_EQ(this->resultOf(kFirstSize<TypeParam> - 1), FBRDF_RESULT_ERROR_VERSION);
    ASSERT_EQ(this->resultOf(kFirstSize<TypeParam>), FBRDF_RESULT_OK);
    const TypeParam value = this->read(kFirstSize<TypeParam>, kFirstSize<TypeParam> - 1);
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    EXPECT_EQ(bytes[kFirstSize<TypeParam> - 1], 1);
    for (size_t i = kFirstSize<TypeParam>; i < sizeof value; ++i) EXPECT_EQ(bytes[i], 0) << i;
}

TYPED_TEST(CApiVersions, NewerCallersAreReadAsFarAsTheyAreZero)
{
    const size_t now = sizeof(TypeParam);
    EXPECT_EQ(this->resultOf(now), FBRDF_RESULT_OK);
    EXPECT_EQ(this->resultOf(now + 4), FBRDF_RESULT_OK);
    for (const size_t set : {now, now + 3})
        EXPECT_EQ(this->resultOf(now + 4, set), FBRDF_RESULT_ERROR_VERSION) << set;
}

// Numbers, not offsetof: whoever changes a struct that programs were compiled with sees it here.
TEST(CApiVersion, FirstSizesStay)
{
    if (sizeof(void*) != 8) GTEST_SKIP() << "found no 64-bit pointers, expected them";
    EXPECT_EQ(kFirstSize<fbrdf_table>, 20u);
    EXPECT_EQ(kFirstSize<fbrdf_material_desc>, 48u);
    EXPECT_EQ(kFirstSize<fbrdf_renderer_desc>, 52u);
    EXPECT_EQ(kFirstSize<fbrdf_gpu_material_desc>, 12u);
    EXPECT_EQ(kFirstSize<fbrdf_mesh_desc>, 48u);
    EXPECT_EQ(kFirstSize<fbrdf_buffer_array>, 16u);
    EXPECT_EQ(kFirstSize<fbrdf_mesh_buffers_desc>, 168u);
    EXPECT_EQ(kFirstSize<fbrdf_hooks_desc>, 44u);
    EXPECT_EQ(kFirstSize<fbrdf_light>, 52u);
    EXPECT_EQ(kFirstSize<fbrdf_item>, 80u);
    EXPECT_EQ(kFirstSize<fbrdf_depth_desc>, 24u);
    EXPECT_EQ(kFirstSize<fbrdf_draw_desc>, 196u);
    EXPECT_EQ(kFirstSize<fbrdf_draw_stats>, 8u);
    EXPECT_EQ(kFirstSize<fbrdf_instance>, 68u);
    EXPECT_EQ(kFirstSize<fbrdf_batch_desc>, 40u);
    EXPECT_EQ(kFirstSize<fbrdf_glsl_desc>, 12u);
    EXPECT_EQ(kFirstSize<fbrdf_environment_desc>, 40u);
    EXPECT_EQ(kFirstSize<fbrdf_environment_light>, 32u);
}

TEST(CApiVersion, ElementsOfAnyVersionAreReadByTheirOwnSize)
{
    struct Newer {
        fbrdf_light light;
        float added;
    } lights[2]{};
    lights[1].light.radius = 3.0f;
    const auto read = [&] { return elements(&lights[0].light, 2, sizeof(Newer), "lights"); };
    EXPECT_EQ(read()[1].radius, 3.0f);
    lights[1].added = 1.0f;
    try {
        read();
        ADD_FAILURE() << "read a field that is not known";
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.result, FBRDF_RESULT_ERROR_VERSION);
        EXPECT_NE(std::string(failure.what()).find("lights[1]: found byte 54 set"),
                  std::string::npos)
            << failure.what();
    }
    EXPECT_TRUE(elements<fbrdf_light>(nullptr, 0, 0, "lights").empty());
    EXPECT_THROW(elements<fbrdf_light>(nullptr, 1, sizeof(fbrdf_light), "lights"), Failure);
    EXPECT_THROW(elements(&lights[0].light, 1, sizeof(fbrdf_light) - 1, "lights"), Failure);
}

TEST(CApiVersion, ReservedFieldsAreForLaterVersions)
{
    fbrdf_item item{};
    item.reserved = 7;
    EXPECT_THROW(known<fbrdf_item>(&item, sizeof item, "item"), Failure);
    EXPECT_NO_THROW(known<fbrdf_item>(&item, offsetof(fbrdf_item, reserved), "item"));
}

TEST(CApiVersion, TextsAreThere)
{
    EXPECT_EQ(fbrdf_api_version(), FBRDF_API_VERSION);
    for (int result = FBRDF_RESULT_OK; result <= FBRDF_RESULT_ERROR_INTERNAL; ++result)
        EXPECT_GT(std::string(fbrdf_result_text(static_cast<fbrdf_result>(result))).size(), 3u);
}

TEST(CApiVersion, SnippetsAreThere)
{
    const char* const names[] = {"fbrdfZenith", "fbrdfDiscPosition", "fbrdfShadingFrame",
                                 "fbrdfIrradiance", "fbrdfSrgbFromLinear"};
    for (uint32_t i = 0; i < 5; ++i)
        EXPECT_NE(std::string(fbrdf_glsl_snippet(i)).find(names[i]), std::string::npos) << i;
    EXPECT_EQ(fbrdf_glsl_snippet(5), nullptr);
}

}  // namespace
}  // namespace fbrdf::capi
