// TechniqueChoice.h - which technique all contexts can draw. osgFX keeps that in vectors that draw
// threads resize while others cull, and asks the first context only; so this is done anew, with a
// lock, and every context is asked when it first draws.
#pragma once
#include "ContextNeeds.h"

#include <osg/StateSet>

#include <OpenThreads/Mutex>

#include <map>
#include <string>
#include <vector>

namespace osgFbrdf {

/// Of one effect. Thread-safe.
class TechniqueChoice : public osg::Referenced {
public:
    /// The best one that every context that was asked can draw; 0, the best of all, where none was.
    int index() const;
    /// Why the last context that refused something did so; empty: none did.
    std::string refusal() const;
    void refuse(const std::string& reason);

    /// The effect has changed: all contexts are to be asked anew, open questions are void.
    void forget();
    void forget(unsigned int contextId);

    bool asked(unsigned int contextId) const;
    /// Asks a context when it draws with this. needs: of the techniques, best first; a context that
    /// refuses them all can draw the one after them.
    osg::ref_ptr<osg::StateSet> question(const std::vector<ContextNeeds>& needs);
    /// Asks the context, which is current, now.
    void ask(osg::State& state, const std::vector<ContextNeeds>& needs);

protected:
    ~TechniqueChoice() override = default;

private:
    class Question;
    unsigned int round() const;
    void ask(osg::State& state, unsigned int round, const std::vector<ContextNeeds>& needs);

    mutable OpenThreads::Mutex mutex_;
    std::map<unsigned int, int> answers_;  ///< index by context
    std::string refusal_;
    unsigned int round_ = 0;  ///< of questions: counts changes of the effect
};

}  // namespace osgFbrdf
