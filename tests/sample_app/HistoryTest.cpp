// HistoryTest.cpp - undo and redo of documents.
#include "SampleDocument.h"

#include <fbrdf/scene/History.h>
#include <gtest/gtest.h>

namespace fbrdf::scene {
namespace {

Document exposed(float exposure)
{
    Document document = sampleDocument();
    document.exposure = exposure;
    return document;
}

TEST(History, GoesBackAndForth)
{
    History history(exposed(1.0f));
    EXPECT_FALSE(history.canUndo() || history.canRedo());
    for (const float exposure : {2.0f, 3.0f}) history.follow(exposed(exposure));
    Document document = exposed(3.0f);
    EXPECT_TRUE(history.undo(document));
    EXPECT_TRUE(document == exposed(2.0f));
    EXPECT_TRUE(history.undo(document));
    EXPECT_TRUE(document == exposed(1.0f));
    EXPECT_FALSE(history.undo(document));
    EXPECT_TRUE(document == exposed(1.0f)) << "without a step nothing changes";
    EXPECT_TRUE(history.redo(document) && history.redo(document));
    EXPECT_TRUE(document == exposed(3.0f));
    EXPECT_FALSE(history.redo(document));
}

TEST(History, WhatHappensBetweenTwoCallsIsOneStep)
{
    History history(exposed(1.0f));
    for (int frame = 0; frame < 10; ++frame) history.follow(exposed(1.0f));
    EXPECT_FALSE(history.canUndo());
    Document document = exposed(9.0f);  // the end of a drag that was not followed
    EXPECT_TRUE(history.undo(document)) << "what was not followed yet is a step";
    EXPECT_EQ(document.exposure, 1.0f);
}

TEST(History, AChangeForgetsWhatWasUndone)
{
    History history(exposed(1.0f));
    history.follow(exposed(2.0f));
    Document document = exposed(2.0f);
    history.undo(document);
    history.follow(exposed(5.0f));
    document = exposed(5.0f);
    EXPECT_FALSE(history.redo(document));
    EXPECT_TRUE(history.undo(document));
    EXPECT_EQ(document.exposure, 1.0f);
}

// The turntable turns on, and windows are resized: nobody wants to undo that.
TEST(History, TheMomentIsNoStep)
{
    History history(exposed(1.0f));
    Document document = exposed(1.0f);
    document.moment = {90.0, 10.0, 100, 50};
    history.follow(document);
    EXPECT_FALSE(history.canUndo());
    document.exposure = 2.0f;
    history.follow(document);
    document.moment.tableDegrees = 180.0;
    EXPECT_TRUE(history.undo(document));
    EXPECT_EQ(document.exposure, 1.0f);
    EXPECT_EQ(document.moment.tableDegrees, 180.0);
    EXPECT_EQ(document.moment.width, 100);
}

// Materials of a scene are loaded while one looks at it.
TEST(History, WhereMaterialsAreLoadedIsNoStepAndStays)
{
    Document document = exposed(1.0f);
    History history(document);
    for (SceneMaterial& material : document.materials) material.slot = 7;
    history.follow(document);
    EXPECT_FALSE(history.canUndo());
    document.exposure = 2.0f;
    history.undo(document);
    EXPECT_EQ(document.materials[1].slot, 7);
}

TEST(History, KeepsSoManyStepsAndNoMore)
{
    History history(exposed(0.0f));
    Document document;
    for (size_t i = 1; i <= History::kKept + 20; ++i) history.follow(exposed(float(i)));
    document = exposed(float(History::kKept + 20));
    size_t steps = 0;
    while (history.undo(document)) ++steps;
    EXPECT_EQ(steps, History::kKept);
    EXPECT_EQ(document.exposure, 20.0f);
}

}  // namespace
}  // namespace fbrdf::scene
