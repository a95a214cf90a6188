#include "PassList.h"

#include <fmt/core.h>

namespace fbrdf::viewer {
namespace {

std::string lightsOf(const Pass& pass)
{
    if (!pass.lit) return pass.parts.empty() ? "" : "factors of the view";
    if (pass.lightCount == 1) return fmt::format("light {}", pass.firstLight + 1);
    return fmt::format("lights {}-{}", pass.firstLight + 1, pass.firstLight + pass.lightCount);
}

}  // namespace

std::string passName(const gl::PassEvent& event)
{
    std::string what = lightsOf(*event.pass);
    const LobeShare& lobes = event.pass->lobes;
    const auto add = [&what](const char* more) {
        what += (what.empty() ? "" : ", ") + std::string(more);
    };
    if (!lobes.isEmpty() && lobes.environment) add("environment");
    if (lobes.areaCount > 0) add("shapes");
    if (what.empty()) what = "no light";
    return fmt::format("{}/{} {}", event.index + 1, event.count, what);
}

PassList::PassList(gl::LoadFunction load) : gl_(loadGlFunctions(load))
{
    GLint bits = 0;
    gl_.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    hasTimers_ = bits > 0;
}

PassList::~PassList()
{
    for (const Timer& timer : timers_) gl_.DeleteQueries(1, &timer.query);
}

gl::PassWatch PassList::watch()
{
    return {[this](const gl::PassEvent& event) { passBegins(event); },
            [this](const gl::PassEvent&) { passEnds(); }};
}

void PassList::begin()
{
    rows_.clear();
    left_ = 0;
    for (Timer& timer : timers_) {
        if (!timer.isPending) continue;
        GLuint isThere = 0;
        gl_.GetQueryObjectuiv(timer.query, GL_QUERY_RESULT_AVAILABLE, &isThere);
        if (!isThere) continue;
        GLuint64 nanoseconds = 0;
        gl_.GetQueryObjectui64v(timer.query, GL_QUERY_RESULT, &nanoseconds);
        timer.milliseconds = 1e-6 * static_cast<double>(nanoseconds);
        timer.isPending = false;
    }
}

void PassList::passBegins(const gl::PassEvent& event)
{
    isTimed_ = false;
    if (rows_.size() == kMostRows) {
        ++left_;
        return;
    }
    const size_t row = rows_.size();
    rows_.push_back(
        {std::string(event.material), passName(event), event.lookups, event.pass->blend});
    if (!hasTimers_) return;
    if (row == timers_.size()) {
        timers_.emplace_back();
        gl_.GenQueries(1, &timers_.back().query);
    }
    Timer& timer = timers_[row];
    const std::string name = rows_[row].material + rows_[row].name;
    if (timer.name == name) rows_[row].milliseconds = timer.milliseconds;
    if (timer.isPending) return;
    if (timer.name != name) timer.milliseconds.reset();
    timer.name = name;
    gl_.BeginQuery(GL_TIME_ELAPSED, timer.query);
    isTimed_ = timer.isPending = true;
}

void PassList::passEnds()
{
    if (isTimed_) gl_.EndQuery(GL_TIME_ELAPSED);
    isTimed_ = false;
}

}  // namespace fbrdf::viewer
