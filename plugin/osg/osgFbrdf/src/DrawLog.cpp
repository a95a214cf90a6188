#include "DrawLog.h"

#include <fbrdf/base/Found.h>

#include <osg/Notify>

#include <OpenThreads/ScopedLock>

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

/// Name of an effect in the log: its own and the file of its material, as far as there are such.
std::string nameOf(const FactorizedBrdf& effect)
{
    const std::string &name = effect.getName(), &file = effect.getMaterialFile();
    if (name.empty()) return file.empty() ? "an effect without a name" : file;
    return "'" + name + "'" + (file.empty() ? "" : ", " + file);
}

std::string lightsLeftOut(const DrawReport& report)
{
    return "lights are left out: found " +
           std::to_string(report.lightsDropped + report.lightsUsed) + ", " +
           std::to_string(report.lightsUsed) +
           " of which are valid and within what the technique can draw" +
           (report.whyLightsInvalid.empty() ? "" : "; an area light: " + report.whyLightsInvalid);
}

}  // namespace

void DrawLog::warnOnce(const FactorizedBrdf& effect, const std::string& kind,
                       const std::string& problem)
{
    if (warned_.insert(kind).second)
        OSG_WARN << "osgFbrdf: " << nameOf(effect) << ": " << problem << std::endl;
}

void DrawLog::report(const FactorizedBrdf& effect, const DrawReport& report)
{
    const Lock lock(mutex_);
    if (!report.reason.empty())
        warnOnce(effect, report.reason, report.technique + " is drawn: " + report.reason);
    if (!report.whyNoEnvironment.empty())
        warnOnce(effect, report.whyNoEnvironment,
                 "drawn without the environment or area lights: " + report.whyNoEnvironment);
    if (!report.whyNoShadows.empty())
        warnOnce(effect, report.whyNoShadows, "drawn without shadows: " + report.whyNoShadows);
    if (!report.whyOpaque.empty())
        warnOnce(effect, report.whyOpaque, "what is blended is drawn opaque: " + report.whyOpaque);
    if (report.environmentsLeftOut > 0)
        warnOnce(effect, "environments",
                 fbrdf::Found(std::to_string(report.environmentsLeftOut + 1) +
                              " environments in the scene, the first of which lights it")
                     .expected("one"));
    // Whoever forces the fallback knows that it has eight lights.
    if (report.lightsDropped > 0 && effect.getSelectedTechnique() != kDiffuseFallback)
        warnOnce(effect, "lights", lightsLeftOut(report));
    last_ = report;
}

void DrawLog::knows(const std::string& reason)
{
    const Lock lock(mutex_);
    warned_.insert(reason);
}

DrawReport DrawLog::last() const
{
    const Lock lock(mutex_);
    return last_;
}

void DrawLog::forgetWarnings()
{
    const Lock lock(mutex_);
    warned_.clear();
}

}  // namespace osgFbrdf
