#include <fbrdf/fitting/GiveWay.h>

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace fbrdf::fitting {

void giveWay()
{
#ifdef __linux__
    // sched(7): five steps of niceness are a third of the weight. Ten, or SCHED_IDLE, gave no
    // shorter frames, and a fit would stand still while the machine builds something.
    constexpr int kSteps = 5;
    const int before = getpriority(PRIO_PROCESS, 0);  // of this thread: setpriority(2), "C library"
    setpriority(PRIO_PROCESS, 0, before + kSteps);
#endif
}

}  // namespace fbrdf::fitting
