#include <fbrdf/base/Error.h>

#include <cstring>

namespace fbrdf {

std::string systemErrorText(int number)
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 32)
    if (const char* text = ::strerrordesc_np(number)) return text;
#endif
    return std::strerror(number);
}

}  // namespace fbrdf
