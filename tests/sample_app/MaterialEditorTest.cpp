// MaterialEditorTest.cpp - materials that follow sliders and drops, without a window.
#include "viewer/MaterialEditor.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <chrono>
#include <filesystem>
#include <thread>

namespace fbrdf::viewer {
namespace {

class Editor : public testing::Test {
protected:
    Editor()
    {
        for (const char* spec : {"ggx:alpha=0.3,f0=0.9", "lambert:albedo=0.2"}) {
            scene::SceneMaterial material;
            material.source = spec;
            material.form = "io";
            material.smoothness = 1e-3;
            material.slot = static_cast<int>(document_.materials.size());
            document_.materials.push_back(material);
            world_.materials.emplace_back(spec, fitOptionsOf(material));
            world_.materials.back().material();
        }
        editor_.emplace(world_, [this](size_t slot) { changes_.push_back(slot); });
        follow(1);
        follow(0);
    }

    void follow(size_t shown)
    {
        document_.shown = static_cast<int>(shown);
        editor_->follow(document_);
    }

    template <class Condition>
    void follow(size_t slot, const Condition& condition)
    {
        for (int i = 0; i < 60000 && !condition(); ++i) {
            follow(slot);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        EXPECT_TRUE(condition()) << editor_->facts().doing << editor_->facts().problem;
    }
    /// Until the material of the slot is fitted, and has lobes of its own.
    void settle(size_t slot)
    {
        follow(slot, [&] {
            return !changes_.empty() && editor_->facts().doing.empty() &&
                   !world_.materials[slot].material().lobes.isEmpty();
        });
    }
    /// Without the search that follows the quick fit.
    template <class Condition>
    void openQuickly(const char* spec, const Condition& isThere)
    {
        editor_->open(spec);
        follow(2, isThere);
        editor_->cancel();
        follow(2, [&] { return editor_->facts().doing.empty(); });
    }
    void setAlpha(size_t slot, double alpha)
    {
        for (const char* name : {"alpha_x", "alpha_y"}) setValue(slot, name, Vec3d(alpha));
    }
    void setValue(size_t slot, const char* name, const Vec3d& value)
    {
        ModelSpec spec = parseModelSpec(document_.materials[slot].source);
        spec.values.at(name) = value;
        document_.materials[slot].source = modelSpecText(spec);
    }
    double reflects(size_t slot) { return world_.materials[slot].truth()(wo_, wo_).x; }

    const Vec3d wo_{0.0, 0.0, 1.0};
    scene::Document document_;
    World world_;
    std::optional<MaterialEditor> editor_;
    std::vector<size_t> changes_;
};

TEST_F(Editor, ASliderIsFollowedByMaterialAndTruth)
{
    setAlpha(0, 0.5);
    settle(0);
    const std::string name = world_.materials[0].name();
    EXPECT_EQ(parseModelSpec(name).values.at("alpha_x").x, 0.5);
    EXPECT_EQ(parseModelSpec(name).values.at("f0"), Vec3d(0.9)) << "what was not moved stays";
    FitOptions options;
    options.form = "io";
    options.smoothness = 1e-3;
    options.heldOut = false;
    const Source source = openSource(name);
    const Material expected = fitMaterial(source, options).material;
    EXPECT_EQ(world_.materials[0].material().tables[0].texels, expected.tables[0].texels);
    EXPECT_EQ(reflects(0), source.evaluate(wo_, wo_).x);
    // The first fit has lobes, as there were none.
    EXPECT_EQ(changes_, (std::vector<size_t>{0}));
    EXPECT_NE(editor_->facts().result.find("io, "), std::string::npos) << editor_->facts().result;
    EXPECT_EQ(editor_->facts().problem, "");
}

// While a slider moves, the lobes of the material before light it; its own come when it rests.
TEST_F(Editor, LobesComeWhenTheSliderRests)
{
    setAlpha(0, 0.5);
    settle(0);
    const LobeTable first = world_.materials[0].material().lobes;
    changes_.clear();
    setAlpha(0, 0.1);
    follow(0, [&] { return changes_.size() == 1; });
    EXPECT_EQ(world_.materials[0].material().lobes.error, first.error);
    follow(0, [&] { return changes_.size() == 2; });
    EXPECT_NE(world_.materials[0].material().lobes.error, first.error);
}

TEST_F(Editor, NothingIsFittedWhereNothingMoves)
{
    for (int i = 0; i < 20; ++i) follow(0);
    EXPECT_EQ(editor_->facts().doing, "");
    EXPECT_TRUE(changes_.empty());
}

TEST_F(Editor, TheLastOfManyPositionsIsTheOneThatStays)
{
    for (int i = 0; i < 50; ++i) {
        setAlpha(0, 0.1 + 0.01 * i);
        follow(0);
    }
    settle(0);
    EXPECT_EQ(parseModelSpec(world_.materials[0].name()).values.at("alpha_x").x, 0.1 + 0.01 * 49);
    EXPECT_LT(changes_.size(), 50u);
}

// What was ordered for one material must not come to the one that is shown now.
TEST_F(Editor, EachReplyComesToItsOwnMaterial)
{
    const double before = reflects(0);
    setValue(1, "albedo", Vec3d(0.6));
    follow(1);
    follow(0, [&] { return !changes_.empty() && editor_->facts().doing.empty(); });
    EXPECT_EQ(reflects(0), before);
    EXPECT_NEAR(reflects(1), 0.6 / kPi, 1e-9);
    for (const size_t slot : changes_) EXPECT_EQ(slot, 1u);
}

TEST_F(Editor, ATooSmallLimitIsNamedAndTheMaterialStays)
{
    const auto before = world_.materials[0].material().tables[0].texels;
    document_.materials[0].form = "hdio";
    document_.materials[0].resolution = 48;
    document_.materials[0].kilobytes = 1;
    follow(0, [&] { return !editor_->facts().problem.empty(); });
    EXPECT_NE(editor_->facts().problem.find("max-bytes: found 1024"), std::string::npos)
        << editor_->facts().problem;
    EXPECT_EQ(world_.materials[0].material().tables[0].texels, before);
    document_.materials[0].kilobytes = 0;
    settle(0);
    EXPECT_NE(world_.materials[0].material().tables[0].texels.size(), before.size());
}

TEST_F(Editor, OpensMaterialsAtOnceAndFitsTheOthersOneByOne)
{
    const test::TemporaryDir folder;
    writeMaterial(world_.materials[0].material(), folder.file("gold.fbrdf"));
    editor_->open(folder.file("gold.fbrdf"));
    follow(0);
    ASSERT_EQ(changes_, (std::vector<size_t>{2}));
    EXPECT_EQ(document_.shown, 2) << "what is dropped is shown";
    EXPECT_FALSE(world_.materials[2].source()) << "a material file has nothing to fit";
    follow(2);
    editor_->open("phong:n=20");
    editor_->open(folder.file("none.csv"));
    editor_->open("lambert:albedo=0.7");
    follow(0, [&] { return world_.materials.size() == 5 && editor_->facts().doing.empty(); });
    EXPECT_EQ(world_.materials[3].name(), "phong:n=20");
    EXPECT_EQ(world_.materials[4].name(), "lambert:albedo=0.7");
    EXPECT_FALSE(world_.materials[3].material().lobes.isEmpty());
    EXPECT_EQ(document_.materials[3].source, "phong:n=20");
    EXPECT_EQ(document_.materials[3].form, world_.materials[3].material().form.name)
        << "a search that ends by the clock is not repeated";
    EXPECT_EQ(document_.materials[4].slot, 4);
    EXPECT_EQ(changes_.back(), 4u);
}

TEST_F(Editor, AFileThatIsDroppedAgainIsReadAgainInItsPlace)
{
    const test::TemporaryDir folder;
    const std::string file = folder.file("grey.fbrdf");
    for (const int drop : {0, 1}) {
        writeMaterial(world_.materials[1 - drop].material(), file);
        editor_->open(file);
        follow(0);
        ASSERT_EQ(document_.materials.size(), 3u);
        EXPECT_EQ(document_.shown, 2);
        EXPECT_EQ(changes_.back(), 2u);
        EXPECT_NEAR(reflects(2), reflects(1 - drop), 0.1 * reflects(2)) << "by its fit";
    }
    openQuickly("phong:n=20", [&] { return document_.materials.size() == 4; });
    const auto chooseIo = [&] {
        changes_.clear();
        document_.materials[3].form = "io";
        settle(3);
        EXPECT_EQ(world_.materials[3].material().form.name, "io");
    };
    chooseIo();
    openQuickly("phong:n=20", [&] { return document_.materials[3].form == "auto"; });
    EXPECT_EQ(document_.materials.size(), 4u);
    EXPECT_EQ(world_.materials.size(), 4u);
    chooseIo();  // as undo would: what it was is made again
}

TEST_F(Editor, AModelThatASliderChangedIsAnotherThanTheOneThatIsOpened)
{
    openQuickly("ggx:alpha=0.2", [&] { return document_.materials.size() == 3; });
    setAlpha(2, 0.5);
    settle(2);
    openQuickly("ggx:alpha=0.2", [&] { return document_.materials.size() == 4; });
    EXPECT_EQ(document_.materials[3].slot, 3);
    EXPECT_GT(reflects(3), 2.0 * reflects(2));
}

TEST_F(Editor, WhatCannotBeOpenedIsNamed)
{
    const test::TemporaryDir folder;
    writeMaterial(world_.materials[0].material(), folder.file("cut.fbrdf"));
    const auto size = std::filesystem::file_size(folder.file("cut.fbrdf"));
    std::filesystem::resize_file(folder.file("cut.fbrdf"), size / 2);
    EXPECT_THROW(editor_->open(folder.file("cut.fbrdf")), Error);
    editor_->open(folder.file("none.csv"));
    follow(0, [&] { return !editor_->facts().problem.empty(); });
    EXPECT_NE(editor_->facts().problem.find("none.csv: found "), std::string::npos)
        << editor_->facts().problem;
    EXPECT_EQ(world_.materials.size(), 2u);
}

// Undo brings back what was: it is not fitted again.
TEST_F(Editor, WhatWasFittedBeforeIsThereAtOnce)
{
    const scene::SceneMaterial before = document_.materials[0];
    const auto texels = world_.materials[0].material().tables[0].texels;
    setAlpha(0, 0.5);
    settle(0);
    const scene::SceneMaterial after = document_.materials[0];
    const auto rough = world_.materials[0].material().tables[0].texels;
    EXPECT_NE(rough, texels);
    document_.materials[0] = before;
    follow(0);
    EXPECT_EQ(editor_->facts().doing, "");
    EXPECT_EQ(world_.materials[0].material().tables[0].texels, texels);
    EXPECT_EQ(world_.materials[0].name(), before.source);
    document_.materials[0] = after;
    follow(0);
    EXPECT_EQ(world_.materials[0].material().tables[0].texels, rough);
}

// A fit that is under way when undo comes must not take the place of what came back.
TEST_F(Editor, AReplyThatUndoOvertakesIsLeftOut)
{
    const scene::SceneMaterial before = document_.materials[0];
    const auto texels = world_.materials[0].material().tables[0].texels;
    setAlpha(0, 0.5);
    follow(0);
    document_.materials[0] = before;
    follow(0, [&] { return editor_->facts().doing.empty(); });
    follow(0);
    EXPECT_EQ(world_.materials[0].material().tables[0].texels, texels);
}

TEST_F(Editor, AFormThatWasSearchedIsNotSearchedAgain)
{
    world_.materials[0].material();
    document_.materials[0].form = "auto";
    // As if it had been loaded so.
    editor_.emplace(world_, [this](size_t slot) { changes_.push_back(slot); });
    follow(0);
    setAlpha(0, 0.5);
    follow(0);
    EXPECT_EQ(document_.materials[0].form, "io");
}

// Materials of a scene have no slots when it is opened.
TEST_F(Editor, LoadsWhatADocumentHasAlready)
{
    const test::TemporaryDir folder;
    writeMaterial(world_.materials[1].material(), folder.file("grey.fbrdf"));
    scene::Document scene;
    for (const std::string& source :
         {folder.file("grey.fbrdf"), std::string("lambert:albedo=0.7"), folder.file("none.csv")}) {
        scene.materials.push_back({source, "io"});
    }
    scene.materials.push_back({document_.materials[0]});
    scene.materials.back().slot = -1;
    document_ = scene;
    follow(0, [&] { return document_.materials[1].slot >= 0 && editor_->facts().doing.empty(); });
    EXPECT_EQ(document_.materials[0].slot, 2) << "a material is there at once";
    EXPECT_EQ(document_.materials[1].slot, 3);
    EXPECT_EQ(document_.materials[2].slot, -1);
    EXPECT_EQ(document_.materials[3].slot, 0) << "what was loaded before is there";
    follow(0, [&] { return !editor_->facts().problem.empty(); });
    EXPECT_NE(editor_->facts().problem.find("none.csv: found "), std::string::npos);
    for (int i = 0; i < 5; ++i) follow(0);
    EXPECT_EQ(editor_->facts().doing, "") << "what cannot be read is not tried again and again";
    EXPECT_EQ(world_.materials.size(), 4u);
}

TEST_F(Editor, ACancelledSearchLeavesTheQuickFitAndForgetsWhatWaits)
{
    editor_->open("ggx:alpha=0.2");
    editor_->open("ggx:alpha=0.4");
    follow(0, [&] { return editor_->facts().doing.find("trying") == 0; });
    ASSERT_EQ(world_.materials.size(), 3u) << "a quick fit is there before the search";
    editor_->cancel();
    follow(0, [&] { return editor_->facts().doing.empty(); });
    EXPECT_EQ(editor_->facts().problem, "the fit was stopped");
    EXPECT_EQ(world_.materials.size(), 3u);
    EXPECT_EQ(world_.materials[2].material().form.name, "hdio");
    EXPECT_EQ(document_.materials.back().slot, 2);
}

TEST_F(Editor, ASearchTakesThePlaceOfTheQuickFit)
{
    editor_->open("ward:rho_d=0.1,rho_s=0.3,alpha_x=0.1,alpha_y=0.4");  // hdio cannot follow it
    follow(2, [&] { return document_.materials.size() == 3; });
    EXPECT_EQ(document_.materials[2].form, "auto");
    const std::string quick = world_.materials[2].material().form.name;
    EXPECT_EQ(quick, "hdio");
    follow(2, [&] { return editor_->facts().doing.empty(); });
    EXPECT_NE(world_.materials[2].material().form.name, quick);
    EXPECT_EQ(document_.materials[2].form, world_.materials[2].material().form.name);
    EXPECT_EQ(world_.materials.size(), 3u);
}

TEST_F(Editor, WhatAProgramBeginsWithGetsLobesOnceSoThatTheFirstFitNeedNotWaitForThem)
{
    ASSERT_TRUE(world_.materials[0].material().lobes.isEmpty());
    editor_->warm(document_);
    settle(0);
    EXPECT_EQ(changes_, std::vector<size_t>{0});
    editor_->warm(document_);
    follow(0);
    EXPECT_EQ(editor_->facts().doing, "") << "once is enough";
}

}  // namespace
}  // namespace fbrdf::viewer
