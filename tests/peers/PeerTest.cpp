#include <fbrdf/peers/Peer.h>
#include <fbrdf/sources/OpenSource.h>

#include "support/DataDir.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/SampleSets.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

PeerContext context()
{
    PeerContext context;
    context.dataDir = test::dataDir();
    context.threads = 1;
    return context;
}

double cubeRootError(const PeerFit& fit, const Source& source)
{
    const auto samples = samplesAt(source, uniformPairs(2000), 1);
    return sampleErrors(samples, evaluateAt(fit.brdf, samples, 1), Vec3f(0.0f)).cubeRootRms;
}

TEST(Peer, NamesAreUniqueAndFound)
{
    for (const Peer& peer : peers()) EXPECT_EQ(&findPeer(peer.name), &peer);
    EXPECT_THROW(findPeer("no such peer"), Error);
}

// kSane: the maps of 2001, in steps of 1/255, reach 0.15 on a dull plastic; all others less.
constexpr double kSane = 0.2;

// Every peer with an answer is sane on a material that all can represent well.
TEST(Peer, EachRepresentsADullMaterial)
{
    const Source source = openSource("ggx:alpha=0.5,f0=0.04,kd=0.3/0.2/0.1");
    for (const Peer& peer : peers()) {
        const auto fit = peer.fit(source, context());
        if (!fit) continue;
        SCOPED_TRACE(peer.name);
        EXPECT_GT(fit->bytes, 0u);
        EXPECT_GE(fit->seconds, 0.0);
        EXPECT_FALSE(fit->note.empty());
        EXPECT_LT(cubeRootError(*fit, source), kSane);
    }
}

TEST(Peer, ThoseOfMerlAnswerByName)
{
    FBRDF_NEEDS_DATA("npf_merl/npf.bin");
    FBRDF_NEEDS_DATA("merl_fits/csv/bagher_sgd.csv");
    FBRDF_NEEDS_DATA("nbrdf/nbrdf_weights.f32");
    const Source rubber = openSource(test::dataPath("nbrdf/nbrdf_weights.f32") + "#blue-rubber");
    const Source other = openSource("lambert");
    for (const char* name : {"sgd", "abc", "npf"}) {
        const auto fit = findPeer(name).fit(rubber, context());
        ASSERT_TRUE(fit) << name;
        EXPECT_LT(cubeRootError(*fit, rubber), kSane) << name;
        EXPECT_FALSE(findPeer(name).fit(other, context())) << name;
    }
}

TEST(Peer, SingularValuesNeedAFunctionOrIsotropicSamples)
{
    Source scattered = openSource("lambert");
    scattered.samples = samplesAt(scattered, uniformPairs(500), 1);
    scattered.evaluate = {};
    EXPECT_TRUE(findPeer("svd").fit(scattered, context()));
    scattered.isotropic = false;
    EXPECT_FALSE(findPeer("svd").fit(scattered, context()));
    EXPECT_LE(peerSamples(scattered, 100, context()).size(), 100u);
}

}  // namespace
}  // namespace fbrdf
