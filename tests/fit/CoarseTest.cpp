#include "solve/Coarse.h"

#include "Known.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

TEST(Coarse, HalvedFormsAreValidAndEnd)
{
    Form form = makeForm("io+pqpr");
    const auto before = texelCount(form.tables[1].domain);
    form = halved(form);
    EXPECT_NO_THROW(validate(form, "halved"));
    EXPECT_LT(texelCount(form.tables[1].domain), before / 3);
    for (int i = 0; i < 10; ++i) form = halved(form);
    EXPECT_EQ(describe(halved(form)), describe(form));
}

TEST(Coarse, ProlongationKeepsAFunctionOfTheCoarseTables)
{
    const Source source = test::sourceOf(test::Ggx{0.4, 0.4, 0.5, 0.1});
    const Dataset dataset = makeDataset(source, 64, 1, 1);
    const DataStatistics statistics =
        statisticsOf(someSamples(dataset, FoldChoice::all(), 64, 1), true, "data");
    const Form form = formPqp(32, 1.0);
    const LeastSquares fine(form, dataset, statistics, 1, 1);
    const LeastSquares coarse = fine.withForm(halved(form));
    State x(3 * coarse.unknowns());
    for (size_t t = 0; t < 2; ++t)
        for (int i = 0; i < 256; ++i)
            for (size_t c = 0; c < 3; ++c)  // linear over the disc
                x[c * coarse.unknowns() + size_t(coarse.layout().unknownOf(t, i))] =
                    0.1 * (i % 16) - 0.2 * (i / 16);
    const State y = prolonged(coarse, x, fine);
    for (int i = 0; i < 1024; ++i)
        EXPECT_NEAR(y[size_t(fine.layout().unknownOf(1, i))],
                    (0.1 * (i % 32) - 0.2 * (i / 32)) * 15.0 / 31.0, 1e-12);
}

}  // namespace
}  // namespace fbrdf
