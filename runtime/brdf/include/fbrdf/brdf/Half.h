// Half.h - IEEE 754 binary16 to and from float, round to nearest even; overflow becomes infinity.
#pragma once
#include <cstdint>

namespace fbrdf {

uint16_t halfFromFloat(float value);
float floatFromHalf(uint16_t bits);

}  // namespace fbrdf
