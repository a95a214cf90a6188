#include "Tensor.h"

#include <fbrdf/base/Found.h>

#include <array>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr std::string_view kTensorMagic("tensor_file\0", 12);
constexpr int kFloat32 = 10;
constexpr std::array<size_t, 12> kTypeSize = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

/// Reads numbers one after the other; every one is checked against the end of the file.
class ByteReader {
public:
    ByteReader(const InputFile& file, size_t at) : file_(file), at_(at) {}

    template <class T>
    T number()
    {
        T value;
        std::memcpy(&value, bytes(sizeof(T)).data(), sizeof(T));
        return value;
    }
    std::string_view bytes(size_t count)
    {
        if (count > file_.size() - at_)
            throw inputError(file_, at_,
                             Found("the end of the file in the table of fields")
                                 .expected(std::to_string(count) + " more bytes"));
        at_ += count;
        return file_.bytes().substr(at_ - count, count);
    }
    size_t at() const { return at_; }

private:
    const InputFile& file_;
    size_t at_;
};

/// Elements of a field; throws when they do not fit into the file.
size_t countOf(const InputFile& file, size_t at, const TensorField& field)
{
    const size_t size = kTypeSize[size_t(field.type)];
    const size_t most = field.offset <= file.size() ? (file.size() - field.offset) / size : 0;
    size_t count = 1;
    for (const size_t extent : field.shape) {
        if (extent != 0 && count > most / extent)
            throw inputError(
                file, at,
                Found("a field that reaches beyond the end of the file").expected("one within it"));
        count *= extent;
    }
    if (count > most)
        throw inputError(
            file, at,
            Found("a field that starts beyond the end of the file").expected("one within it"));
    return count;
}

TensorField readField(const InputFile& file, ByteReader& reader)
{
    constexpr size_t kMostDimensions = 16;
    TensorField field;
    const size_t start = reader.at();
    const size_t dimensions = reader.number<uint16_t>();
    field.type = reader.number<uint8_t>();
    field.offset = reader.number<uint64_t>();
    if (dimensions > kMostDimensions || field.type < 1 || size_t(field.type) >= kTypeSize.size())
        throw inputError(file, start,
                         Found("type " + std::to_string(field.type) + " and " +
                               std::to_string(dimensions) + " dimensions")
                             .expected("types 1 to 11 and at most 16"));
    for (size_t i = 0; i < dimensions; ++i) field.shape.push_back(reader.number<uint64_t>());
    field.count = countOf(file, start, field);
    return field;
}

bool hasShape(const TensorField& field, const std::vector<size_t>& shape)
{
    if (field.shape.size() != shape.size()) return false;
    for (size_t i = 0; i < shape.size(); ++i)
        if (field.shape[i] == 0 || (shape[i] != 0 && field.shape[i] != shape[i])) return false;
    return true;
}

/// `zero` is what an extent of 0 reads: "0" in a file, "any" in an expectation.
std::string shapeText(const std::vector<size_t>& shape, const char* zero)
{
    std::string text = "[";
    for (const size_t extent : shape)
        text += (text.size() > 1 ? ", " : "") + (extent ? std::to_string(extent) : zero);
    return text + "]";
}

}  // namespace

bool isTensorFile(const InputFile& file)
{
    return file.bytes().substr(0, kTensorMagic.size()) == kTensorMagic;
}

TensorFields readTensorFields(const InputFile& file)
{
    constexpr uint32_t kMostFields = 4096;
    if (!isTensorFile(file)) throw inputError(file, 0, Found("no 'tensor_file'").expected("it"));
    ByteReader reader(file, kTensorMagic.size());
    const int major = reader.number<uint8_t>(), minor = reader.number<uint8_t>();
    if (major != 1 || minor != 0)
        throw inputError(file, kTensorMagic.size(),
                         Found("version " + std::to_string(major) + "." + std::to_string(minor))
                             .expected("1.0"));
    const uint32_t count = reader.number<uint32_t>();
    if (count > kMostFields)
        throw inputError(file, kTensorMagic.size() + 2,
                         Found(std::to_string(count) + " fields").expected("at most 4096"));
    TensorFields fields;
    for (uint32_t i = 0; i < count; ++i) {
        const std::string name(reader.bytes(reader.number<uint16_t>()));
        fields[name] = readField(file, reader);
    }
    return fields;
}

std::vector<float> readTensor(const InputFile& file, const TensorFields& fields,
                              const std::string& name, const std::vector<size_t>& shape)
{
    const auto found = fields.find(name);
    if (found == fields.end())
        throw inputError(file, Found("no field '" + name + "'").expected("it"));
    const TensorField& field = found->second;
    if (field.type != kFloat32 || !hasShape(field, shape))
        throw inputError(file,
                         Found("field '" + name + "' of type " + std::to_string(field.type) +
                               " and shape " + shapeText(field.shape, "0"))
                             .expected("type 10 (float32) and shape " + shapeText(shape, "any")));
    std::vector<float> values(field.count);
    std::memcpy(values.data(), file.bytes().data() + field.offset, field.count * sizeof(float));
    for (size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw inputError(
                file, field.offset + i * sizeof(float),
                Found("a value of '" + name + "' that is not finite").expected("finite ones"));
    return values;
}

}  // namespace fbrdf
