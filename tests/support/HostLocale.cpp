// HostLocale.cpp - makes a program that it is preloaded into (LD_PRELOAD) a host whose locale is
// that of its environment, in C and in C++, as GUI toolkits do at their start. Without it LC_ALL
// changes nothing in a program that never asks for its locale. See tests/run-locales.sh.
#include <clocale>
#include <locale>

namespace {

struct HostLocale {
    HostLocale()
    {
        if (!std::setlocale(LC_ALL, "")) return;  // no such locale: the tests see that of C
        std::locale::global(std::locale(""));
    }
} hostLocale;

}  // namespace
