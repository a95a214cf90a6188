// Forms that no least squares gives, through every command that takes a material.
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

const char* const kModel = "ward:rho_d=0.2,rho_s=0.1,alpha_x=0.3,alpha_y=0.3";

class DirectForms : public testing::TestWithParam<const char*> {
protected:
    DirectForms() : material_(folder_.file("m.fbrdf"))
    {
        const auto fit = jsonFrom(runTool({"fit", kModel, "-o", material_, "--form", GetParam(),
                                           "--json", "--report", folder_.file("r.html")}));
        EXPECT_EQ(fit["form"], GetParam());
        form_ = fit;
    }

    TemporaryDir folder_;
    std::string material_;
    nlohmann::json form_;
};

TEST_P(DirectForms, AreMaterialsLikeAnyOther)
{
    const auto info = jsonFrom(runTool({"info", material_, "--json"}));
    EXPECT_EQ(info["form"], GetParam());
    const auto compared = jsonFrom(runTool({"compare", material_, kModel, "--json"}));
    EXPECT_GT(compared["errors"]["psnr_linear"].get<double>(), 30.0);
    ToolOptions options;
    options.input = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0,1,0.6,0,0.8\n";
    EXPECT_EQ(runTool({"eval", material_, "--pairs", "-"}, options).code, 0);
    EXPECT_NE(readText(folder_.file("r.html")).find("</html>"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Forms, DirectForms, testing::Values("svd4", "analytic"));

}  // namespace
}  // namespace fbrdf::test
