// Assert.h - preconditions that only a mistake of the caller's code can break.
//
// FBRDF_ASSERT(count, <=, limit) compares its first and last argument. Where the comparison is
// false, a build with FBRDF_ASSERTIONS (CMake defines it in Debug) writes the expression, both
// values, file and line to stderr and aborts. Other builds evaluate neither argument. What a user,
// a file or a driver can cause is an Error (Error.h) instead. For use in .cpp files: a host's own
// flags must not change what an inline function of a public header does.
#pragma once

#if defined(FBRDF_ASSERTIONS)
#include <cstdlib>
#include <iostream>

namespace fbrdf::detail {

template <class A, class B>
[[noreturn]] void assertionFailed(const A& a, const char* op, const B& b, const char* expression,
                                  const char* file, int line)
{
    std::cerr << file << ":" << line << ": assertion " << expression << " failed: found " << a
              << " " << op << " " << b << std::endl;
    std::abort();
}

}  // namespace fbrdf::detail

#define FBRDF_ASSERT(a, op, b)                                                                 \
    do {                                                                                       \
        const auto& fbrdfA = (a);                                                              \
        const auto& fbrdfB = (b);                                                              \
        if (!(fbrdfA op fbrdfB))                                                               \
            ::fbrdf::detail::assertionFailed(fbrdfA, #op, fbrdfB, #a " " #op " " #b, __FILE__, \
                                             __LINE__);                                        \
    } while (false)
#else
#define FBRDF_ASSERT(a, op, b) static_cast<void>(sizeof((a)op(b)))
#endif
