// StateTest.h - the fixture of tests that set any state and look at what a call leaves of it.
#pragma once
#include "StateList.h"
#include "StateScrambler.h"

#include "support/gl/GlTest.h"

namespace fbrdf::test {

class StateTest : public RendererTest {
protected:
    void SetUp() override
    {
        RendererTest::SetUp();
        if (isReady()) scrambler_ = std::make_unique<StateScrambler>(gl(), isCore());
    }
    void TearDown() override
    {
        scrambler_.reset();
        RendererTest::TearDown();
    }
    bool isCore() const { return !GetParam().legacy; }
    StateSnapshot now() const { return snapshot(gl(), isCore()); }

    std::unique_ptr<StateScrambler> scrambler_;
};

}  // namespace fbrdf::test
