#include "Motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fbrdf::viewer {
namespace {

constexpr double kTurnRate = 20.0;    ///< of the turntable, degrees a second
constexpr double kOrbitRate = 30.0;   ///< of the lights
constexpr double kLongestStep = 0.1;  ///< seconds that one frame turns it by, at most

}  // namespace

void Motion::follow(scene::Document& document, bool isStanding)
{
    const auto now = std::chrono::steady_clock::now();
    const double step = std::min(
        kLongestStep, std::chrono::duration<double>(now - std::exchange(last_, now)).count());
    if (isStanding) return;
    const auto turnOn = [step](bool turns, double rate, double& degrees) {
        if (turns) degrees = std::fmod(degrees + rate * step, 360.0);
    };
    turnOn(document.turning, kTurnRate, document.moment.tableDegrees);
    turnOn(document.orbiting, kOrbitRate, document.moment.lightsDegrees);
}

}  // namespace fbrdf::viewer
