// Materials in scripts of OGRE: how they are written, saved and read again, and what is wrong.
#include "OgreTest.h"

#include "support/FileBytes.h"

#include <fbrdf/io/MaterialFile.h>

#include <sstream>

namespace fbrdf::test {
namespace {

// Twice the same programs on the same numbers.
constexpr double kSame = 1e-6;

class OgreScripts : public OgreTest {
protected:
    void SetUp() override
    {
        OgreTest::SetUp();
        host().addMesh("sphere", sphereMesh(24));
        host().setView(perspectiveView());
        for (const Light& light : unlimitedLights(9)) host().addLight(light);
        writeMaterial(everythingMaterial(), file("two words.fbrdf"));
        addMaterial("plain", everythingMaterial());
    }

    /// A material with this text in its section rtshader_system.
    std::vector<float> drawn(const std::string& name, const std::string& section)
    {
        host().addScript("material " + name + "\n{\ntechnique\n{\npass\n{\nrtshader_system\n{\n" +
                         section + "\n}\n}\n}\n}\n");
        return drawn(name);
    }
    std::vector<float> drawn(const std::string& name)
    {
        Ogre::Entity* entity = host().addEntity("sphere", name);
        std::vector<float> pixels = host().picture();
        entity->setVisible(false);
        return pixels;
    }
    static std::vector<float> times(float factor, std::vector<float> pixels)
    {
        for (size_t i = 0; i < pixels.size(); ++i)
            if (i % 4 < 3) pixels[i] *= factor;
        return pixels;
    }
    void expectSame(const std::vector<float>& found, const std::vector<float>& expected)
    {
        const auto d = compareImages(found, expected);
        EXPECT_TRUE(d.comparable && d.maxRelative < kSame) << describe(d);
    }
    std::string saved(const std::string& name)
    {
        Ogre::MaterialSerializer serializer;
        serializer.addListener(host().generator().getMaterialSerializerListener());
        serializer.queueForExport(Ogre::MaterialManager::getSingleton().getByName(name), true);
        return serializer.getQueuedAsString();
    }
};
FBRDF_ON_BOTH_SYSTEMS(OgreScripts);

TEST_P(OgreScripts, LinesAndBlocksMeanTheSame)
{
    const auto plain = drawn("plain");
    const auto line = drawn("line", "fbrdf plain.fbrdf exposure 2 technique single");
    expectSame(line, times(2.0f, plain));
    expectSame(drawn("block", "fbrdf plain.fbrdf\n{\nexposure 2\ntechnique single\n}"), line);
    expectSame(drawn("brief", "fbrdf plain.fbrdf { exposure 2 technique single }"), line);
}

TEST_P(OgreScripts, TransfersAreThoseOfTheRuntime)
{
    const auto radiance = drawn("plain");
    for (const auto& [name, transfer] :
         {std::pair{"srgb", Transfer::srgb}, std::pair{"tone-map", Transfer::toneMap}}) {
        const auto stored = drawn(name, std::string("fbrdf plain.fbrdf transfer ") + name);
        for (size_t i = 0; i < stored.size(); ++i) {
            const double expected =
                i % 4 == 3 ? static_cast<double>(radiance[i])
                           : transferred(transfer, 1.0, static_cast<double>(radiance[i]));
            ASSERT_NEAR(static_cast<double>(stored[i]), expected, 1e-5) << name << i;
        }
    }
}

TEST_P(OgreScripts, PreciseFilteringDrawsTheSame)
{
    const auto d =
        compareImages(drawn("precise", "fbrdf plain.fbrdf preciseFiltering 1"), drawn("plain"));
    EXPECT_TRUE(d.comparable && d.meanRelative < 1e-4) << describe(d);
}

TEST_P(OgreScripts, WhatIsSavedIsReadAgain)
{
    const auto expected = drawn("line", "fbrdf plain.fbrdf exposure 0.3 transfer tone-map");
    std::string text = saved("line");
    EXPECT_NE(text.find("fbrdf plain.fbrdf exposure 0.3 transfer tone-map\n"), std::string::npos)
        << text;
    text.replace(text.find("material line"), 13, "material again");
    host().addScript(text);
    expectSame(drawn("again"), expected);
}

TEST_P(OgreScripts, NamesWithSpacesAreQuoted)
{
    const auto plain = drawn("plain");
    expectSame(drawn("line", "fbrdf \"two words.fbrdf\" exposure 1"), plain);
    expectSame(drawn("block", "fbrdf \"two words.fbrdf\" { exposure 1 }"), plain);
    std::string text = saved("line");
    EXPECT_NE(text.find("fbrdf \"two words.fbrdf\"\n"), std::string::npos) << text;
    text.replace(text.find("material line"), 13, "material again");
    host().addScript(text);
    expectSame(drawn("again"), plain);
}

TEST_P(OgreScripts, BadOptionsAreRefusedAndTheRestIsDrawn)
{
    const auto plain = drawn("plain");
    expectSame(drawn("a", "fbrdf plain.fbrdf exposure -1"), plain);
    expectSame(drawn("b", "fbrdf plain.fbrdf { transfer gamma }"), plain);
    expectSame(drawn("c", "fbrdf plain.fbrdf technique batched"), plain);
    expectSame(drawn("d", "fbrdf plain.fbrdf shine 3"), plain);
    const char* const words[] = {"option 'exposure=-1': found a value out of range",
                                 "option 'transfer=gamma': found a value out of range",
                                 "option 'technique=batched': found a value out of range",
                                 "option 'shine': found no such option"};
    const auto lines = takeLog();
    ASSERT_EQ(lines.size(), 4u);
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(lines[i], std::string("ogreFbrdf: plain.fbrdf: ") + words[i]);
}

/// The first block of the page between ``` and the word after it, and ```.
std::string blockOf(const std::string& page, const std::string& kind)
{
    const std::string head = "\n```" + kind + "\n";
    const size_t begin = page.find(head) + head.size();
    return page.substr(begin, page.find("```", begin) - begin);
}

TEST_P(OgreScripts, ThePageOfTheDocumentationIsRight)
{
    const std::string page = fileBytes("docs/ogre.md");
    const std::string script = blockOf(page, "");
    ASSERT_EQ(script.find("material gold\n"), 0u);
    writeMaterial(everythingMaterial(), file("gold.fbrdf"));
    host().addScript(script);
    addMaterial("same", everythingMaterial(), "exposure 2 transfer tone-map");
    expectSame(drawn("gold"), drawn("same"));
    // Its C++ is that of the example.
    const std::string example = fileBytes("plugin/ogre/example/main.cpp");
    std::istringstream lines(blockOf(page, "cpp"));
    size_t at = 0, count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        at = example.find(line, at);
        ASSERT_NE(at, std::string::npos) << line;
    }
    EXPECT_EQ(count, 7u);
}

}  // namespace
}  // namespace fbrdf::test
