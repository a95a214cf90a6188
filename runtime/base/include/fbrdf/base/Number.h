// Number.h - numbers as text, the same in every locale. A host program may have called setlocale,
// or std::locale::global, with a language whose decimal sign is a comma, and printf, std::to_string
// and streams follow it; texts for shaders, files and people may not.
#pragma once
#include <string>

namespace fbrdf {

/// At most `digits` significant digits without trailing zeros, as printf's "%.*g" has them in the
/// locale "C": "0.25", "1e-07", "inf", "nan". 9 digits give every float back, 17 every double.
std::string numberText(double value, int digits = 6);

/// `decimals` digits after the point, as "%.*f" has them: "0.250000".
std::string fixedText(double value, int decimals = 6);

}  // namespace fbrdf
