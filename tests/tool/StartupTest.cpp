// StartupTest.cpp - what a process loads that reads a material or asks for the version.
#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

/// The files that a run of the tool loads, as the loader of glibc lists them.
std::string filesLoaded(const std::vector<std::string>& arguments)
{
    ToolOptions options;
    options.environment = {"LD_DEBUG=files"};
    const ToolRun run = runTool(arguments, options);
    EXPECT_EQ(run.code, 0);
    EXPECT_NE(run.err.find("libOpenEXR"), std::string::npos);  // the list is there
    return run.err;
}

TEST(Startup, NothingButPicturesLoadsOpenImageIO)
{
    const TemporaryDir folder;
    const std::string material = folder.file("m.fbrdf");
    writeMaterial(smallMaterial("pqp"), material);
    const std::string pairs = folder.file("pairs.csv");
    writeText(pairs, "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0,1,0.6,0,0.8\n");
    const std::vector<std::string> commands[] = {
        {"--version"}, {"info", material}, {"eval", material, "--pairs", pairs}};
    for (const auto& command : commands)
        EXPECT_EQ(filesLoaded(command).find("OpenImageIO"), std::string::npos) << command[0];
}

TEST(Startup, LibfbrdfNeedsNoOpenImageIO)
{
    ToolOptions options;
    options.launcher = {"ldd", FBRDF_C_LIBRARY};
    const std::string libraries = runTool({}, options).out;
    EXPECT_NE(libraries.find("libOpenEXRCore"), std::string::npos) << libraries;
    EXPECT_EQ(libraries.find("OpenImageIO"), std::string::npos) << libraries;
}

}  // namespace
}  // namespace fbrdf::test
