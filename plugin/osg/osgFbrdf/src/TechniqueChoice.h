// TechniqueChoice.h - chooses the technique that all contexts can draw. osgFX keeps its choice in
// vectors that draw threads resize while others cull, and asks the first context only. So the
// choice is made anew here, with a lock, and every context is asked when it first draws.
#pragma once
#include "ContextNeeds.h"

#include <osg/StateSet>

#include <OpenThreads/Mutex>

#include <map>
#include <string>
#include <vector>

namespace osgFbrdf {

/// One effect has one. Thread-safe.
class TechniqueChoice : public osg::Referenced {
public:
    /// Index of the best technique that every context that was asked can draw; 0, the best of all,
    /// where none was asked.
    int index() const;
    /// Why the last context that refused something did so; empty: none did.
    std::string refusal() const;
    void refuse(const std::string& reason);

    /// The effect has changed: all contexts are to be asked anew, and probes that are still to be
    /// applied do nothing.
    void forget();
    void forget(unsigned int contextId);

    /// Why nothing can be drawn in the context; empty where something can, or it was not asked.
    std::string whyNothing(unsigned int contextId) const;
    /// What every context that was asked has; more than anything needs where none was.
    ContextLimits limits() const;
    bool asked(unsigned int contextId) const;
    /// State that asks a context when the context draws with it. needs: of the techniques, best
    /// first; a context that refuses them all can draw the one after them.
    osg::ref_ptr<osg::StateSet> probe(const std::vector<ContextNeeds>& needs);
    /// Asks the context, which is current, now.
    void ask(osg::State& state, const std::vector<ContextNeeds>& needs);

protected:
    ~TechniqueChoice() override = default;

private:
    class Probe;
    unsigned int round() const;
    void ask(osg::State& state, unsigned int round, const std::vector<ContextNeeds>& needs);

    mutable OpenThreads::Mutex mutex_;
    struct Answer {
        int index;
        ContextLimits limits;
        std::string whyNothing;
    };
    std::map<unsigned int, Answer> answers_;  ///< by context
    std::string refusal_;
    unsigned int round_ = 0;  ///< counts changes of the effect
};

}  // namespace osgFbrdf
