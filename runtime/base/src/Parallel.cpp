#include <fbrdf/base/Parallel.h>

namespace fbrdf {

int threadCount(int asked)
{
    return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace fbrdf
