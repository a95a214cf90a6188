// DrawLog.h - what the last cull of an effect did, and the warnings about it, each given once:
// views and frames may differ in what they can draw, and numbers of lights change, so that a
// warning a frame would drown the log. Thread-safe.
#pragma once
#include <osgFbrdf/FactorizedBrdf.h>

#include <OpenThreads/Mutex>

#include <set>
#include <string>

namespace osgFbrdf {

class DrawLog {
public:
    /// Keeps the report. Warns by osg::notify, with the name and file of the effect, where another
    /// technique was drawn than the one selected or where lights were left out.
    void report(const FactorizedBrdf& effect, const DrawReport& report);
    DrawReport last() const;
    /// The reason is in the log already.
    void knows(const std::string& reason);
    /// The effect has changed: what it was warned of may be warned of again.
    void forgetWarnings();

private:
    void warnOnce(const FactorizedBrdf& effect, const std::string& kind,
                  const std::string& problem);

    mutable OpenThreads::Mutex mutex_;
    DrawReport last_;
    std::set<std::string> warned_;  ///< kinds of warnings that the log has
};

}  // namespace osgFbrdf
