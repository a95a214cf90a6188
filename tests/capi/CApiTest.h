// CApiTest.h - the fixture of tests of the C ABI in a context, and a log that keeps its lines.
#pragma once
#include <fbrdf/fbrdf.hpp>

#include "support/gl/GlTest.h"

#include <string>
#include <vector>

namespace fbrdf::test {

struct Line {
    fbrdf_severity severity;
    fbrdf_result code;
    std::string text;
};
using Lines = std::vector<Line>;

inline void write(void* user, fbrdf_severity severity, fbrdf_result code, const char* text)
{
    static_cast<Lines*>(user)->push_back({severity, code, text});
}

class CApiTest : public GlTest {
protected:
    fbrdf_renderer_desc rendererDesc(Lines& lines)
    {
        auto desc = abi::describe<fbrdf_renderer_desc>();
        desc.api_version = FBRDF_API_VERSION;
        desc.load = context().loader();
        desc.log = {write, &lines};
        return desc;
    }
};

}  // namespace fbrdf::test
