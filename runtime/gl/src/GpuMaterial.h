// GpuMaterial.h - the tables of a material as textures and uniforms.
#pragma once
#include "Objects.h"

#include <fbrdf/shaders/TextureImage.h>

#include <vector>

namespace fbrdf::gl {

struct GpuTable {
    Object texture;  ///< empty for a uniform table
    GLenum target = GL_TEXTURE_2D;
    Vec3f lower{0.0f}, extent{1.0f};  ///< see TextureImage
    std::vector<Vec3f> knots;         ///< of a uniform table
};

class GpuMaterial {
public:
    /// Throws Error(input) for an invalid material, Error(gl) where GL cannot hold a table.
    GpuMaterial(DevicePtr device, const Material& material);

    const Device* device() const { return device_.get(); }
    uint64_t id() const { return id_; }  ///< unique on its device
    const std::string& name() const { return name_; }
    const Form& form() const { return form_; }
    const std::vector<TableEncoding>& encodings() const { return encodings_; }
    const std::vector<GpuTable>& tables() const { return tables_; }
    const std::vector<Vec3f>& scales() const { return scales_; }

private:
    void addTexture(const Table& table);

    DevicePtr device_;
    uint64_t id_;
    std::string name_;
    Form form_;
    std::vector<TableEncoding> encodings_;
    std::vector<GpuTable> tables_;
    std::vector<Vec3f> scales_;
};

}  // namespace fbrdf::gl
