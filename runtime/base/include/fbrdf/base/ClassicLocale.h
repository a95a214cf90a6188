// ClassicLocale.h - the locale "C" for calls into libraries that read numbers as the host's has
// them.
#pragma once
#include <clocale>

#include <locale.h>

namespace fbrdf {

/// While it lives, C functions that the calling thread calls (strtod, printf) follow the locale
/// "C", whatever setlocale has set for the process. Streams of C++ do not: they have a locale each.
class ClassicLocale {
public:
    ClassicLocale() : classic_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(classic_))
    {
    }
    ~ClassicLocale()
    {
        uselocale(before_);
        if (classic_) freelocale(classic_);
    }
    ClassicLocale(const ClassicLocale&) = delete;
    ClassicLocale& operator=(const ClassicLocale&) = delete;

private:
    locale_t classic_, before_;
};

}  // namespace fbrdf
