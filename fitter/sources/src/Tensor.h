// Tensor.h - the container of EPFL's RGL data: named arrays in one file.
// Little endian: "tensor_file\0", version bytes 1 and 0, uint32 count of fields; for each field
// uint16 length of its name, the name, uint16 number of dimensions, uint8 type, uint64 offset of
// its data from the start of the file, uint64 for each dimension; data in C order (last dimension
// contiguous). Types 1 to 11: u8 i8 u16 i16 u32 i32 u64 i64 f16 f32 f64.
// The layout follows the comments of the database's reader, powitacq (Dupuy and Jakob 2018).
#pragma once
#include "InputFile.h"

#include <cstdint>
#include <map>
#include <vector>

namespace fbrdf {

struct TensorField {
    std::vector<size_t> shape;
    int type = 0;
    size_t offset = 0;  ///< byte of the first element
    size_t count = 0;   ///< elements in all; they lie inside the file
};

using TensorFields = std::map<std::string, TensorField>;

bool isTensorFile(const InputFile& file);

/// Throws Error(input) at the byte where the table of fields stops making sense.
TensorFields readTensorFields(const InputFile& file);

/// The float32 elements of a field. Throws Error(input) unless it exists, is float32, has the given
/// shape (0 stands for any size of at least 1) and every element is finite.
std::vector<float> readTensor(const InputFile& file, const TensorFields& fields,
                              const std::string& name, const std::vector<size_t>& shape);

}  // namespace fbrdf
