// DataDir.h - where the third-party reflectance data is: FBRDF_DATA_DIR, or ../shared/data from the
// working directory (ctest runs every test in the project's root). The data is never part of the
// project, so a test that needs it declares that:
//   TEST(Cornell, ReadsGarnetRed)
//   {
//       FBRDF_NEEDS_DATA("cornell_pbrt2/garnet_red.brdf");
//       const auto source =
//       fbrdf::openSource(fbrdf::test::dataPath("cornell_pbrt2/garnet_red.brdf"));
// Where the data is absent the test is skipped by name; with CI=true in the environment it fails.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace fbrdf::test {

inline std::string dataDir()
{
    const char* directory = std::getenv("FBRDF_DATA_DIR");
    return directory && *directory ? directory : "../shared/data";
}

/// Path of a file or folder of the data, whether it exists or not.
inline std::string dataPath(const std::string& relative)
{
    return (std::filesystem::path(dataDir()) / relative).string();
}

inline bool dataExists(const std::string& relative)
{
    std::error_code ignored;
    return std::filesystem::exists(dataPath(relative), ignored);
}

/// True on a build server, where absent data is a failure and not a reason to skip.
inline bool dataIsMandatory()
{
    const char* ci = std::getenv("CI");
    return ci && std::string(ci) == "true";
}

}  // namespace fbrdf::test

/// Leaves the calling test unless `path` (relative to the data's root) is there.
#define FBRDF_NEEDS_DATA(path)                                                     \
    do {                                                                           \
        if (!fbrdf::test::dataExists(path)) {                                      \
            if (fbrdf::test::dataIsMandatory())                                    \
                FAIL() << "CI=true, but no " << fbrdf::test::dataPath(path);       \
            GTEST_SKIP() << "needs " << fbrdf::test::dataPath(path)                \
                         << ": set FBRDF_DATA_DIR to the folder of the test data"; \
        }                                                                          \
    } while (false)
