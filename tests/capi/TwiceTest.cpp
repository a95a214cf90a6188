// The library loaded twice into one process, under two names, as two plugins would.
#include "Materials.h"

#include <gtest/gtest.h>

#include "support/BuiltFile.h"

#include <dlfcn.h>

#include <filesystem>

namespace fbrdf::test {
namespace {

std::filesystem::path library()
{
    return builtFile("FBRDF_C_LIBRARY", FBRDF_LIBRARY);
}

/// One loaded copy of the library.
class Copy {
public:
    explicit Copy(const std::filesystem::path& path)
        : library_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL))
    {
    }
    ~Copy()
    {
        if (library_) dlclose(library_);
    }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;
    explicit operator bool() const { return library_ != nullptr; }
    template <class Function>
    Function* function(const char* name) const
    {
        return reinterpret_cast<Function*>(dlsym(library_, name));
    }

private:
    void* library_;
};

float evaluated(const Copy& copy, float exponent)
{
    const GivenMaterial given(constantMaterial(formPqp(3, 0.5), exponent));
    const fbrdf_material_desc desc = given.desc();
    fbrdf_material* material = nullptr;
    if (copy.function<decltype(fbrdf_material_create)>("fbrdf_material_create")(&desc, nullptr,
                                                                                &material))
        return -1.0f;
    const float up[3] = {0.0f, 0.0f, 1.0f};
    float rgb[3] = {};
    copy.function<decltype(fbrdf_material_evaluate)>("fbrdf_material_evaluate")(material, up, up,
                                                                                rgb);
    copy.function<decltype(fbrdf_material_release)>("fbrdf_material_release")(material);
    return rgb[0];
}

TEST(CApiTwice, TwoCopiesLiveSideBySide)
{
    const std::filesystem::path second =
        std::filesystem::path(::testing::TempDir()) / "libfbrdf-second.so";
    std::filesystem::copy_file(library(), second,
                               std::filesystem::copy_options::overwrite_existing);
    {
        const Copy one(library());
        ASSERT_TRUE(one) << dlerror();
        {
            const Copy two(second);
            ASSERT_TRUE(two) << dlerror();
            ASSERT_NE(one.function<void()>("fbrdf_draw"), two.function<void()>("fbrdf_draw"));
            EXPECT_NEAR(evaluated(two, -1.0f), 0.125f, 1e-6f);
            EXPECT_NEAR(evaluated(one, -2.0f), 1.0f / 64.0f, 1e-6f);
        }
        EXPECT_NEAR(evaluated(one, -1.0f), 0.125f, 1e-6f);  // and after the other has gone
    }
    std::filesystem::remove(second);
}

}  // namespace
}  // namespace fbrdf::test
