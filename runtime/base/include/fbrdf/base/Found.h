// Found.h - the sentence that every Error (Error.h) about a wrong value ends in.
#pragma once
#include <string>
#include <utility>

namespace fbrdf {

/// Found("2 columns").expected("3 or 6") reads "found 2 columns, expected 3 or 6". To be thrown as
/// Error(kind, where, Found(...).expected(...)); the two names keep the halves from being swapped.
class Found {
public:
    explicit Found(std::string what) : what_(std::move(what)) {}
    std::string expected(const std::string& what) const
    {
        return "found " + what_ + ", expected " + what;
    }

private:
    std::string what_;
};

}  // namespace fbrdf
