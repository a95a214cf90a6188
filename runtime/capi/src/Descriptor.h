// Descriptor.h - descriptors of any version: struct_size bytes from the caller over defaults.
#pragma once
#include <fbrdf/fbrdf.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace fbrdf::capi {

/// What a function returns, as an exception up to the boundary.
struct Failure : std::runtime_error {
    Failure(fbrdf_result r, const std::string& text) : std::runtime_error(text), result(r) {}
    fbrdf_result result;
};

/// The caller's descriptor as this library knows it: what the caller does not have is 0. `least`:
/// bytes that the first version had. Throws Failure.
template <class T>
T descriptor(const T* given, size_t least, const char* name)
{
    if (!given)
        throw Failure(FBRDF_ERROR_ARGUMENT,
                      std::string(name) + ": found NULL, expected a descriptor");
    uint32_t size = 0;
    std::memcpy(&size, given, sizeof size);
    if (size < least)
        throw Failure(FBRDF_ERROR_VERSION, std::string(name) + ": found struct_size " +
                                               std::to_string(size) + ", expected at least " +
                                               std::to_string(least));
    const auto* bytes = reinterpret_cast<const unsigned char*>(given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i] != 0)
            throw Failure(FBRDF_ERROR_VERSION,
                          std::string(name) + ": found byte " + std::to_string(i) +
                              " set, expected 0 in what this library does not know");
    T result{};
    std::memcpy(&result, given, size < sizeof(T) ? size : sizeof(T));
    return result;
}

}  // namespace fbrdf::capi
