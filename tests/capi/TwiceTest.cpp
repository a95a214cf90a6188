// The library loaded twice into one process, under two names, as two plugins would.
#include <fbrdf/fbrdf.h>

#include <gtest/gtest.h>

#include <dlfcn.h>

#include <array>
#include <filesystem>

namespace fbrdf::test {
namespace {

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
    std::array<float, 27> texels;
    texels.fill(exponent);
    const float* const tables[2] = {texels.data(), texels.data()};
    fbrdf_brdf_desc desc{};
    desc.struct_size = sizeof desc;
    desc.size[0] = 3;
    desc.table_count = 2;
    desc.tables = tables;
    fbrdf_brdf* brdf = nullptr;
    if (copy.function<decltype(fbrdf_brdf_create)>("fbrdf_brdf_create")(&desc, nullptr, &brdf))
        return -1.0f;
    const float up[3] = {0.0f, 0.0f, 1.0f};
    float rgb[3] = {};
    copy.function<decltype(fbrdf_brdf_evaluate)>("fbrdf_brdf_evaluate")(brdf, up, up, rgb);
    copy.function<decltype(fbrdf_brdf_release)>("fbrdf_brdf_release")(brdf);
    return rgb[0];
}

TEST(CApiTwice, TwoCopiesLiveSideBySide)
{
    const std::filesystem::path second =
        std::filesystem::path(::testing::TempDir()) / "libfbrdf-second.so";
    std::filesystem::copy_file(FBRDF_LIBRARY, second,
                               std::filesystem::copy_options::overwrite_existing);
    {
        const Copy one(FBRDF_LIBRARY);
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
