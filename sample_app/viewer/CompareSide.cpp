#include "CompareSide.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/peers/Peer.h>
#include <fbrdf/sources/Model.h>

#include <algorithm>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

using Kind = CompareSide::Kind;

constexpr const char* kDrawn = "drawn";
constexpr const char* kNetwork = "nbrdf";
constexpr int kSideLobes = 2;  // as MaterialEditor.cpp
constexpr size_t kSideMeasured = 16384;
constexpr double kSideSeconds = 10.0;  // that a search of the form takes, at most

bool isTechnique(const std::string& name)
{
    for (int i = 0; i < scene::kViewTechniqueCount; ++i)
        if (name == viewTechniqueName(static_cast<scene::ViewTechnique>(i))) return true;
    return false;
}

/// Those that are forms of the fitter as well are fitted as forms, but for the maps of 2001: the
/// form of that name has 8 bits of logarithms.
const Peer* peerOf(const std::string& name)
{
    if (name == "svd" || name == "analytic") return nullptr;
    const auto peer = std::find_if(peers().begin(), peers().end(),
                                   [&name](const Peer& p) { return p.name == name; });
    return peer == peers().end() ? nullptr : &*peer;
}

bool isForm(const std::string& name)
{
    FitOptions options;
    options.form = name;
    try {
        checkOptions(options);
        return true;
    } catch (const Error&) {
        return false;
    }
}

bool isSource(const std::string& name)
{
    return namesModel(name) ||
           std::filesystem::exists(std::filesystem::path(name.substr(0, name.find_first_of("#@"))));
}

std::string weightsFile()
{
    return (std::filesystem::path(publishedDataDir()) / "nbrdf/nbrdf_weights.f32").string();
}

/// The network of a source by its name; empty: none is published, or not here.
std::string networkOf(const Source& source)
{
    const std::string file = weightsFile(), spec = file + "#" + source.name;
    if (!std::filesystem::exists(file)) return "";
    const std::vector<std::string> all = materialsOf(file);
    return std::find(all.begin(), all.end(), spec) == all.end() ? "" : spec;
}

std::string noFit(const std::string& name, const std::string& found, const std::string& expected)
{
    return name + ": " + Found(found).expected(expected);
}

fitting::FitOrder orderFor(const std::string& source)
{
    fitting::FitOrder order;
    order.source = source;
    order.lobes = kSideLobes;
    order.fit.heldOut = false;
    order.fit.measured = kSideMeasured;
    order.fit.seconds = kSideSeconds;
    return order;
}

}  // namespace

CompareSide compareSideFromName(const std::string& name)
{
    if (name == kDrawn) return {};
    if (name == kNetwork) return {Kind::network, name};
    if (isTechnique(name)) return {Kind::technique, name};
    if (peerOf(name)) return {Kind::peer, name};
    if (isForm(name)) return {Kind::form, name};
    if (isSource(name)) return {Kind::source, name};
    throw Error(ErrorKind::usage, "--compare", Found("'" + name + "'").expected(compareSideHelp()));
}

bool namesFile(const std::string& side)
{
    return side != kDrawn && side != kNetwork && !isTechnique(side) && !peerOf(side) &&
           !isForm(side) && !namesModel(side);
}

std::string compareSideHelp()
{
    std::string known;
    for (const Peer& peer : peers())
        if (peerOf(peer.name)) known += ", " + peer.name;
    return std::string(kDrawn) +
           ", the name of a technique, a form (fbrdf forms; svdK: K singular "
           "values)" +
           known + ", nbrdf, or a file or model" +
           (peersLeftOut().empty() ? "" : "; without " + peersLeftOut());
}

std::vector<CompareSide> offeredSides()
{
    std::vector<CompareSide> sides{{}};
    for (const auto technique : {scene::ViewTechnique::reference, scene::ViewTechnique::vertex})
        sides.push_back({Kind::technique, viewTechniqueName(technique)});
    for (const Peer& peer : peers())
        if (peerOf(peer.name)) sides.push_back({Kind::peer, peer.name});
    sides.push_back({Kind::network, kNetwork});
    sides.push_back({Kind::form, "svd4"});
    for (const NamedForm& form : namedForms())
        if (!peerOf(form.name)) sides.push_back({Kind::form, form.name});
    for (const char* sum : {"io+hdio", "io+pqpr"}) sides.push_back({Kind::form, sum});
    return sides;
}

std::string titleOf(const CompareSide& side)
{
    switch (side.kind) {
        case Kind::drawn: return "as drawn";
        case Kind::technique:
            if (side.name == viewTechniqueName(scene::ViewTechnique::reference))
                return "reference per pixel";
            if (side.name == viewTechniqueName(scene::ViewTechnique::vertex))
                return "truth at vertices";
            return side.name;
        case Kind::form:
            return side.name.rfind("svd", 0) == 0
                       ? (side.name == "svd" ? "" : side.name.substr(3) + " ") + "singular values"
                       : "form " + side.name;
        case Kind::peer:
            if (side.name == "pqp-2001") return "pqp of 2001, linear 8 bits";
            if (side.name == "ggx") return "best GGX";
            if (side.name == "ggx2") return "best two GGX";
            return findPeer(side.name).title;
        case Kind::network: return "NBRDF weights";
        case Kind::source: break;
    }
    const std::filesystem::path path(side.name);
    return std::filesystem::exists(path) ? path.filename().string() : side.name;
}

std::string whyNot(const CompareSide& side, const MaterialSlot& shown)
{
    if (side.kind != Kind::form && side.kind != Kind::peer && side.kind != Kind::network) return "";
    if (!shown.source())
        return noFit(side.name, "a material file, without the data it was fitted to",
                     "a measurement or a model as the material");
    const Source& source = *shown.source();
    if (side.kind == Kind::network && networkOf(source).empty())
        return noFit(side.name, "no network of '" + source.name + "'",
                     "one in " + weightsFile() + " (FBRDF_DATA_DIR)");
    if (side.kind == Kind::form && !suitsForm(source, side.name))
        return noFit(side.name, "nothing for '" + source.name + "'",
                     side.name == "analytic" ? "a model whose factors are known"
                                             : "a function, or isotropic samples");
    return "";
}

std::optional<fitting::FitOrder> orderOf(const CompareSide& side, const MaterialSlot& shown)
{
    fitting::FitOrder order = orderFor(shown.name());
    order.opened = shown.source();
    switch (side.kind) {
        case Kind::drawn:
        case Kind::technique: return std::nullopt;
        case Kind::form: order.fit.form = side.name; return order;
        case Kind::peer: order.peer = side.name; return order;
        case Kind::network:
            order = orderFor(networkOf(*shown.source()));
            order.functionIsEnough = true;
            return order;
        case Kind::source: break;
    }
    order = orderFor(side.name);
    order.functionIsEnough = true;
    return order;
}

MaterialSlot slotOf(const CompareSide& side, const fitting::FitReply& reply)
{
    if (reply.material) return {titleOf(side), reply.source, *reply.material};
    Source function;
    function.name = titleOf(side);
    function.format = "peer";
    function.description = reply.note;
    function.isotropic = reply.source->isotropic;
    function.evaluate = reply.brdf;
    MaterialSlot slot(titleOf(side), std::make_shared<const Source>(std::move(function)));
    if (!reply.lobes.isEmpty()) slot.setLobes(reply.lobes);
    return slot;
}

std::string noteOf(const CompareSide& side, const MaterialSlot& shown)
{
    if (side.kind != Kind::technique || shown.truthIsSource() ||
        !scene::isOnCpu(scene::viewTechniqueFromName(side.name)))
        return "";
    return shown.source() ? "the data are samples and no function: this is the fit, in double"
                          : "a material file: this is the material, in double";
}

scene::ViewTechnique techniqueOf(const CompareSide& side, const MaterialSlot& slot,
                                 scene::ViewTechnique chosen)
{
    if (side.kind == Kind::technique) return scene::viewTechniqueFromName(side.name);
    if (side.kind != Kind::drawn && !slot.hasMaterial()) return scene::ViewTechnique::reference;
    return isOnCpu(chosen) ? scene::viewTechnique(Technique::single) : chosen;
}

}  // namespace fbrdf::viewer
