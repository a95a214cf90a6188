// Descriptor.h - structs of callers of any version: their bytes over defaults of 0.
#pragma once
#include "FirstSizes.h"

#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace fbrdf::capi {

/// What a function returns, as an exception up to the boundary.
struct Failure : std::runtime_error {
    Failure(fbrdf_result r, const std::string& text) : std::runtime_error(text), result(r) {}
    fbrdf_result result;
};

/// What a struct keeps for later versions; 0 where it keeps nothing.
template <class T>
auto reservedOf(const T& value, int) -> decltype(value.reserved)
{
    return value.reserved;
}
template <class T>
uint32_t reservedOf(const T&, long)
{
    return 0;
}

[[noreturn]] inline void refuseVersion(const char* name, size_t index, const std::string& text)
{
    const std::string place = index == SIZE_MAX ? "" : "[" + std::to_string(index) + "]";
    throw Failure(FBRDF_RESULT_ERROR_VERSION, name + place + ": " + text);
}

/// A struct of which the caller has `size` bytes: what the caller does not have is 0. Throws
/// Failure for fewer bytes than any version has, and for bytes that mean something to a later
/// version only.
template <class T>
T known(const void* given, size_t size, const char* name, size_t index = SIZE_MAX)
{
    if (size < kFirstSize<T>)
        refuseVersion(name, index,
                      Found("a size of " + std::to_string(size) + " bytes")
                          .expected("at least " + std::to_string(kFirstSize<T>)));
    const auto* bytes = static_cast<const unsigned char*>(given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i] != 0)
            refuseVersion(name, index,
                          Found("byte " + std::to_string(i) + " set")
                              .expected("0 in fields that this library does not know"));
    T result{};
    std::memcpy(&result, given, std::min(size, sizeof(T)));
    if (reservedOf(result, 0) != 0)
        refuseVersion(name, index,
                      Found("reserved " + std::to_string(reservedOf(result, 0))).expected("0"));
    return result;
}

/// The caller's descriptor; its size is its first field. Throws Failure as known().
template <class T>
T descriptor(const T* given, const char* name)
{
    if (!given)
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      std::string(name) + ": " + Found("NULL").expected("a descriptor"));
    uint32_t size = 0;
    std::memcpy(&size, given, sizeof size);
    return known<T>(given, size, name);
}

/// The elements of a caller's array, each of `size` bytes. Throws Failure as known().
template <class T>
std::vector<T> elements(const T* array, uint32_t count, uint32_t size, const char* name)
{
    std::vector<T> result;
    if (count == 0) return result;
    if (!array)
        throw Failure(
            FBRDF_RESULT_ERROR_ARGUMENT,
            std::string(name) + ": " + Found("NULL").expected(std::to_string(count) + " elements"));
    const auto* bytes = reinterpret_cast<const unsigned char*>(array);
    for (size_t i = 0; i < count; ++i) result.push_back(known<T>(bytes + i * size, size, name, i));
    return result;
}

}  // namespace fbrdf::capi
