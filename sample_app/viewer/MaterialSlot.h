// MaterialSlot.h - one --material: the truth it stands for, and the factored material drawn by GL.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/scene/CpuRenderer.h>
#include <fbrdf/scene/Document.h>
#include <fbrdf/sources/Source.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace fbrdf::viewer {

/// How a material of a document is fitted.
FitOptions fitOptionsOf(const scene::SceneMaterial& material);

class MaterialSlot {
public:
    /// `spec`: a material file, or a source (fbrdf/sources/Source.h). Throws what readMaterial and
    /// openSource throw. `options`: how a source will be fitted.
    explicit MaterialSlot(const std::string& spec, FitOptions options = {});

    /// A source that has been opened already, and one that has been fitted already.
    MaterialSlot(const std::string& spec, std::shared_ptr<const Source> source,
                 FitOptions options = {});
    MaterialSlot(const std::string& spec, std::shared_ptr<const Source> source, Material material);

    const std::string& name() const { return name_; }
    /// What can be fitted; null: the slot is a material file.
    const std::shared_ptr<const Source>& source() const { return source_; }
    /// Takes the place of what there was. The truth() that was taken before is none any more.
    void replace(const std::string& spec, std::shared_ptr<const Source> source, Material material);
    bool hasMaterial() const { return material_.has_value(); }
    /// The factored material; a source is fitted on the first call, which may throw Error(fit).
    const Material& material();
    /// f of the source where it is a function, else of the material (in double).
    scene::Brdf truth();
    /// Lobes of the truth, by which paths of light are drawn (fbrdf/truth/PathTracer.h): those of
    /// the material where it is the truth and has some, else fitted on the first call.
    const LobeTable& lobes();
    void setLobes(LobeTable lobes) { lobes_ = std::move(lobes); }
    bool truthIsSource() const { return source_ && source_->evaluate; }

private:
    std::string name_;
    FitOptions options_;
    std::shared_ptr<const Source> source_;
    std::optional<Material> material_;
    std::optional<LobeTable> lobes_;
};

}  // namespace fbrdf::viewer
