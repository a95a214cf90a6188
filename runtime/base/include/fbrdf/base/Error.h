// Error.h - the one exception type of the libraries. The value of its kind is the exit code of the
// tools.
#pragma once
#include <stdexcept>
#include <string>

namespace fbrdf {

enum class ErrorKind {
    usage = 2,   ///< an argument, option, form or model that does not exist or is out of range
    input = 3,   ///< a file that is missing, unreadable or invalid
    fit = 4,     ///< data from which no material can be fitted
    output = 5,  ///< a file that cannot be written
    gl = 6,      ///< no usable OpenGL
};

/// what() reads "WHERE: what was found, what was expected"; WHERE holds the file and its line or
/// byte where known.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, const std::string& where, const std::string& what)
        : std::runtime_error(where + ": " + what), kind_(kind)
    {
    }
    ErrorKind kind() const noexcept { return kind_; }

private:
    ErrorKind kind_;
};

/// What the system says of a value of errno, "No such file or directory", in English whatever
/// language the host has set, where the C library can (glibc does).
std::string systemErrorText(int number);

}  // namespace fbrdf
