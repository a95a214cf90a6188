// MaterialResources.h - the tables of a material as textures and uniforms; or of many of one
// layout, as texture arrays and a buffer (PackedParameters.h).
#pragma once
#include "BufferTexture.h"
#include "MaterialLobes.h"

#include <fbrdf/plan/Plan.h>
#include <fbrdf/shaders/TextureImage.h>

#include <glm/vec4.hpp>

#include <vector>

namespace fbrdf::gl {

struct GpuTable {
    Object texture;  ///< empty for a uniform table
    GLenum target = GL_TEXTURE_2D;
    Vec3f lower{0.0f}, extent{1.0f};  ///< see TextureImage
    std::vector<Vec3f> knots;         ///< the values of a uniform table
};

class MaterialResources {
public:
    /// Throws Error(input) for an invalid material, Error(gl) where GL cannot store a table.
    MaterialResources(DevicePtr device, const Material& material,
                      const MaterialOptions& options = {});
    /// Packs materials, one or more, which are valid and of one layout (sameLayout).
    MaterialResources(DevicePtr device, const std::vector<const Material*>& layers, bool precise);

    ~MaterialResources() { device_->retiredMaterials.push_back(id_); }
    MaterialResources(const MaterialResources&) = delete;
    MaterialResources& operator=(const MaterialResources&) = delete;

    /// Puts another material, valid and of the same layout, into a layer. Throws Error(gl).
    void replaceLayer(size_t layer, const Material& material);
    bool isPacked() const { return !packed_.empty(); }
    GLuint parameters() const { return parameters_.texture(); }

    const Device* device() const { return device_.get(); }
    uint64_t id() const { return id_; }  ///< unique on its device
    const std::string& name() const { return name_; }
    const Form& form() const { return form_; }
    bool hasSigns() const { return hasSigns_; }
    /// See Handles.h.
    const std::string& whyNotRecombined() const { return whyNotRecombined_; }
    double lookUpError() const { return lookUpError_; }
    /// Shader where that filters all maps.
    Filter filter() const;
    /// The product of a term may be off by so much, |log2|, because textures are filtered coarsely.
    double filterError() const { return mapErrors(0.0).filtering; }
    /// Of what is looked up, under lights whose irradiances (Peaks::lights) add up to `irradiance`.
    MapErrors mapErrors(double irradiance) const;
    /// The largest values of the tables, without lights; those of all layers that a packed material
    /// has ever had.
    const Peaks& peaks() const { return peaks_; }
    const std::vector<TableEncoding>& encodings() const { return encodings_; }
    const std::vector<GpuTable>& tables() const { return tables_; }
    const std::vector<Vec3f>& scales() const { return scales_; }
    /// True where it looks different when the tangents turn.
    bool isAnisotropic() const;
    /// How it reflects environments; what is fitted on demand is no part of what others see of it.
    MaterialLobes& lobes() const { return lobes_; }
    /// Of a packed material: the lobes of each layer, their rows, and the largest of their errors.
    const LobeLayout& packedLobes() const { return packedLobes_; }
    GLuint lobeRows() const { return lobeRows_.texture(); }
    double lobeError() const { return lobeError_; }

private:
    TextureImage imageOf(const Table& table, int index, const MaterialOptions& options);
    void addTexture(const Table& table, const TextureImage& image);
    void raisePeaks(const Material& material);
    void setLookUpError(const std::vector<TextureImage>& images);
    void raiseFilterError(size_t table, const TextureImage& image, GLenum target);
    void measureFilters(const Material& material) const;
    void addArray(const Table& table, size_t layers, bool precise);
    void setLayer(size_t layer, const Material& material);
    void uploadParameters();

    DevicePtr device_;
    uint64_t id_;
    std::string name_;
    Form form_;
    bool hasSigns_ = false;
    std::string whyNotRecombined_;
    double lookUpError_ = 0.0;
    double exponent_ = 0.0;             ///< largestExponent, of all layers ever
    std::vector<double> filterErrors_;  ///< of each table, in its unit (filterError)
    Peaks peaks_;
    std::vector<TableEncoding> encodings_;
    std::vector<GpuTable> tables_;
    std::vector<Vec3f> scales_;
    mutable MaterialLobes lobes_;
    std::vector<glm::vec4> packed_;  ///< the contents of parameters_: layers x stride
    BufferTexture parameters_;
    LobeLayout packedLobes_;
    std::vector<glm::vec4> packedRows_;  ///< the contents of lobeRows_
    double lobeError_ = 0.0;
    BufferTexture lobeRows_;
};

}  // namespace fbrdf::gl
