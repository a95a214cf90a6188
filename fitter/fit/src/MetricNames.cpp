#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/fit/Fit.h>

namespace fbrdf {

const char* metricName(Metric metric)
{
    switch (metric) {
        case Metric::log: return "log";
        case Metric::cubeRoot: return "cuberoot";
        case Metric::log1p: return "log1p";
    }
    return "?";
}

Metric metricFromName(const std::string& name)
{
    for (const Metric m : {Metric::log, Metric::cubeRoot, Metric::log1p})
        if (name == metricName(m)) return m;
    throw Error(ErrorKind::usage, "metric",
                Found("'" + name + "'").expected("log, cuberoot or log1p"));
}

}  // namespace fbrdf
