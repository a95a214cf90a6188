// MaterialLobes.h - how a material reflects environments. Files from before there were lobes have
// none: theirs are fitted on a thread of their own when they are first wanted.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <future>
#include <map>
#include <memory>
#include <string>

namespace fbrdf::gl {

class MaterialLobes {
public:
    MaterialLobes() = default;
    /// Keeps a copy of a material without lobes until they are fitted.
    explicit MaterialLobes(const Material& material);

    /// The lobes, at most `most` of them (0: all); null where there are none yet, see whyNot. The
    /// first call of a material without lobes starts the fit.
    const LobeTable* find(int most);
    /// Starts a fit that has to be, and waits for it.
    void wait();
    /// The lobes that there are already; null where there are none, and nothing is started.
    const LobeTable* known() const { return table_.isEmpty() ? nullptr : &table_; }
    /// Why find has returned null.
    const std::string& whyNot() const { return whyNot_; }
    /// True where the lobes that came with the material are about bent normals.
    bool areBent() const { return !table_.isEmpty() && table_.axes == LobeAxes::bent; }

private:
    void start();
    void take();

    LobeTable table_;
    std::map<int, LobeTable> fewer_;  ///< by the number asked for
    std::shared_ptr<const Material> material_;
    std::future<LobeTable> fit_;  ///< its destructor waits
    std::string whyNot_ = "no lobes";
};

}  // namespace fbrdf::gl
