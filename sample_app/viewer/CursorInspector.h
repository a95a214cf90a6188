// CursorInspector.h - what the window says about the place under the cursor: CursorProbe.h, kept up
// to date, with the maps that are read as textures.
#pragma once
#include "CursorProbe.h"
#include "GlFunctions.h"

#include <array>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace fbrdf::viewer {

/// One of two BRDFs that are asked about.
struct CursorSubject {
    std::string title;
    scene::Brdf brdf;
    const Material* material = nullptr;  ///< whose maps are read; null: it has none
    int revision = 0;                    ///< another where the material is another
};

/// A table as a texture, and where it is read.
struct MapView {
    std::string name;      ///< "q(h)"
    unsigned texture = 0;  ///< GL name, row 0 first
    int width = 0, height = 0;
    Vec3d position{0.0};  ///< in texels
    Stencil<double> texels;
    Vec3d value{0.0};
};

struct CursorFacts {
    bool hits = false;
    Vec2<double> place{0.0};  ///< shares of width and height
    ProbeLight light;
    ProbeAngles angles;
    struct Subject {
        std::string title;
        const Material* material = nullptr;  ///< whose maps are read; null: it has none
        Vec3d f{0.0};
        PolarCurve curve;
        std::vector<MapView> maps;
    };
    std::array<Subject, 2> subjects;
    PolarCurve samples;
    std::string samplesNote;  ///< how many there are, or why there are none
    double most = 1.0;        ///< the largest f of the plot
};

/// What is asked about.
struct CursorQuestion {
    Vec2<double> place{0.0};
    std::vector<scene::Instance> instances;
    gl::View view;
    const scene::LightSet* lights = nullptr;
    std::array<CursorSubject, 2> subjects;
    std::shared_ptr<const Source> source;  ///< of the material that is shown; may be null
};

/// Owns GL objects of the context that is current when it is made; all calls need that context.
class CursorInspector {
public:
    explicit CursorInspector(gl::LoadFunction load);
    ~CursorInspector();
    CursorInspector(const CursorInspector&) = delete;
    CursorInspector& operator=(const CursorInspector&) = delete;

    void answer(const CursorQuestion& question);
    const CursorFacts& facts() const { return facts_; }

private:
    struct Map {
        GLuint texture = 0;
        int width = 0, height = 0, revision = -1, slice = -1;
        const Material* material = nullptr;
    };
    void answerFor(size_t subject, const CursorSubject& asked, const DirectionPair<double>& pair);
    const Map& mapOf(size_t subject, const CursorSubject& asked, int table, int slice);
    void findSamples(const std::shared_ptr<const Source>& source, const Vec3d& wi);

    GladGLContext gl_;
    CursorFacts facts_;
    std::map<std::pair<size_t, int>, Map> maps_;  ///< by subject and table
    std::shared_ptr<const Source> source_;        ///< of samples_
    std::shared_ptr<const PlaneSamples> samples_;
    std::future<std::shared_ptr<const PlaneSamples>> reading_;
};

}  // namespace fbrdf::viewer
