// Orders are fitted one after the other on a thread; what the tests wait for comes on any machine.
#include <gtest/gtest.h>

#include <fbrdf/base/Number.h>
#include <fbrdf/fitting/FitWorker.h>

#include "support/TemporaryDir.h"

#include <chrono>
#include <fstream>
#include <locale>
#include <thread>

namespace fbrdf::fitting {
namespace {

FitOrder ggx(double alpha)
{
    FitOrder order;
    order.source = "ggx:alpha=" + fixedText(alpha) + ",f0=0.9/0.6/0.3,kd=0.1";
    order.fit.form = "io";
    order.fit.heldOut = false;
    order.fit.smoothness = 1e-3;
    order.lobes = 0;
    return order;
}

/// One that takes minutes.
FitOrder longOrder()
{
    FitOrder order = ggx(0.2);
    order.fit.form = "best-of";
    return order;
}

template <class Condition>
void wait(const Condition& condition)
{
    for (int i = 0; i < 60000 && !condition(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

FitReply nextReply(FitWorker& worker)
{
    std::optional<FitReply> reply;
    wait([&] { return bool(reply = worker.take()); });
    EXPECT_TRUE(reply) << worker.doing();
    return reply.value_or(FitReply{});
}

TEST(FitWorker, FitsWhatTheLibraryFits)
{
    FitWorker worker;
    EXPECT_EQ(worker.doing(), "");
    EXPECT_FALSE(worker.take());
    EXPECT_EQ(worker.order(ggx(0.3)), 1);
    const FitReply reply = nextReply(worker);
    EXPECT_EQ(reply.number, 1);
    EXPECT_EQ(reply.error, "");
    ASSERT_TRUE(reply.material);
    const FitOrder order = ggx(0.3);
    const Material expected = fitMaterial(openSource(order.source), order.fit).material;
    ASSERT_EQ(reply.material->tables.size(), expected.tables.size());
    for (size_t i = 0; i < expected.tables.size(); ++i)
        EXPECT_EQ(reply.material->tables[i].texels, expected.tables[i].texels);
    EXPECT_GT(reply.summary.all.logMedian, 0.0);
    EXPECT_TRUE(reply.material->lobes.isEmpty());
    EXPECT_FALSE(worker.take()) << "each reply comes once";
    wait([&] { return worker.doing().empty(); });
    EXPECT_EQ(worker.doing(), "");
}

TEST(FitWorker, AddsLobesWhereAskedTo)
{
    FitWorker worker;
    FitOrder order = ggx(0.4);
    order.lobes = 2;
    worker.order(order);
    const FitReply reply = nextReply(worker);
    ASSERT_TRUE(reply.material) << reply.error;
    EXPECT_FALSE(reply.material->lobes.isEmpty());
}

// While a slider is dragged the newest order counts, and none that has begun is lost.
TEST(FitWorker, TheNewestOrderTakesThePlaceOfTheOneThatWaits)
{
    FitWorker worker;
    constexpr int kOrders = 40;
    std::vector<int> replied;
    for (int i = 0; i < kOrders; ++i) {
        worker.order(ggx(0.2 + 0.01 * i));
        if (const auto reply = worker.take()) replied.push_back(reply->number);
    }
    while (replied.empty() || replied.back() != kOrders)
        replied.push_back(nextReply(worker).number);
    EXPECT_TRUE(std::is_sorted(replied.begin(), replied.end()));
    EXPECT_LT(replied.size(), static_cast<size_t>(kOrders)) << "most were replaced";
    EXPECT_FALSE(worker.take());
}

TEST(FitWorker, StopEndsALongFitAndTheNextOrderWorks)
{
    FitWorker worker;
    worker.order(longOrder());
    wait([&] { return worker.doing().find("trying") == 0; });
    EXPECT_EQ(worker.doing().find("trying"), 0u) << worker.doing();
    worker.order(ggx(0.3));  // which waits, and is forgotten
    worker.stop();
    const FitReply stopped = nextReply(worker);
    EXPECT_EQ(stopped.number, 1);
    EXPECT_TRUE(stopped.isStopped);
    EXPECT_EQ(stopped.error, "the fit was stopped");
    EXPECT_FALSE(stopped.material);
    wait([&] { return worker.doing().empty(); });
    EXPECT_FALSE(worker.take());
    worker.order(ggx(0.3));
    const FitReply next = nextReply(worker);
    EXPECT_EQ(next.number, 3);
    EXPECT_TRUE(next.material) << next.error;
}

TEST(FitWorker, AnOrderThatIsStoppedAtOnceHasAReplyWhetherItHadBegunOrNot)
{
    FitWorker worker;
    for (int number = 1; number <= 50; ++number) {
        worker.order(longOrder());
        worker.stop();
        const FitReply reply = nextReply(worker);
        EXPECT_EQ(reply.number, number);
        EXPECT_TRUE(reply.isStopped);
    }
}

TEST(FitWorker, GoesInTheMiddleOfAFit)
{
    FitWorker worker;
    worker.order(longOrder());
    wait([&] { return worker.doing().find("trying") == 0; });
}

TEST(FitWorker, SaysWhatTheToolSays)
{
    FitWorker worker;
    FitOrder order = ggx(0.3);
    order.source = "no-such-file.binary";
    worker.order(order);
    const FitReply missing = nextReply(worker);
    EXPECT_NE(missing.error.find("no-such-file.binary: found "), std::string::npos)
        << missing.error;
    EXPECT_FALSE(missing.isStopped);
    order.source = "ggx:alpha=-1";
    worker.order(order);
    EXPECT_NE(nextReply(worker).error.find("alpha"), std::string::npos);
    order = ggx(0.3);
    order.fit.form = "no-such-form";
    worker.order(order);
    EXPECT_NE(nextReply(worker).error.find("no-such-form"), std::string::npos);
    worker.order(ggx(0.3));
    EXPECT_TRUE(nextReply(worker).material);
}

// The file is read once for many orders, but again where it has changed.
TEST(FitWorker, ReadsAFileAgainThatHasChanged)
{
    const test::TemporaryDir folder;
    const std::string path = folder.file("scan.csv");
    const auto write = [&path](double value) {
        std::ofstream file(path);
        file.imbue(std::locale::classic());
        file << "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,r,g,b\n";
        for (int i = 0; i < 40; ++i)
            for (int k = 0; k < 40; ++k) {
                const double a = 1.4 * (i + 0.5) / 40, b = 1.4 * (k + 0.5) / 40;
                file << std::sin(a) << ",0," << std::cos(a) << ',' << std::sin(b) << ",0,"
                     << std::cos(b) << ',' << value << ',' << value << ',' << value << '\n';
            }
    };
    FitWorker worker;
    FitOrder order = ggx(0.3);
    order.source = path;
    const auto fitted = [&] {
        worker.order(order);
        const FitReply reply = nextReply(worker);
        EXPECT_TRUE(reply.material) << reply.error;
        const Vec3d wo(0.0, 0.0, 1.0), wi(std::sin(0.7), 0.0, std::cos(0.7));
        return reply.material ? evaluate<double>(*reply.material, wo, wi).x : 0.0;
    };
    write(0.1);
    const auto before = std::filesystem::last_write_time(path);
    EXPECT_NEAR(fitted(), 0.1, 0.005);
    write(0.2);
    std::filesystem::last_write_time(path, before + std::chrono::seconds(2));
    EXPECT_NEAR(fitted(), 0.2, 0.01);
}

}  // namespace
}  // namespace fbrdf::fitting
