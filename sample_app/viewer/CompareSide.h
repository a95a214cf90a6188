// CompareSide.h - what stands on one side of a comparison: the material that is shown, drawn in
// some way, or something else that is fitted to the same source or read from a file.
#pragma once
#include "MaterialSlot.h"

#include <fbrdf/fitting/FitOrder.h>
#include <fbrdf/scene/Controls.h>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

struct CompareSide {
    enum class Kind {
        drawn,      ///< the material, by the technique of the runtime that is chosen
        technique,  ///< the material, by the technique of that name
        form,       ///< the source, fitted in the form of that name
        peer,       ///< the source, as a peer (fbrdf/peers/Peer.h) has it
        network,    ///< the published NBRDF of that source
        source      ///< another file or model
    } kind = Kind::drawn;
    std::string name = "drawn";  ///< as --compare takes it

    /// False where the shown material is all that it takes.
    bool needsFit() const { return kind != Kind::drawn && kind != Kind::technique; }
    bool operator==(const CompareSide& o) const { return kind == o.kind && name == o.name; }
};

/// Throws Error(usage) for what is none of compareSideHelp().
CompareSide compareSideFromName(const std::string& name);
std::string compareSideHelp();
/// True for a name that can only be that of a file, whether that is there or not.
bool namesFile(const std::string& side);
/// Sides without a file of their own, for a list to choose from. Singular values are among them as
/// "svd4".
std::vector<CompareSide> offeredSides();
/// For people: "best two GGX lobes".
std::string titleOf(const CompareSide& side);

/// Why a material has no such side, in one line as errors have it; empty: it has.
std::string whyNot(const CompareSide& side, const MaterialSlot& shown);
/// What has to be fitted or opened for it; nothing where the shown material is all it needs.
/// Expects that whyNot is empty.
std::optional<fitting::FitOrder> orderOf(const CompareSide& side, const MaterialSlot& shown);
/// What came of such an order, without errors.
MaterialSlot slotOf(const CompareSide& side, const fitting::FitReply& reply);

/// What people should know of a side of the shown material: that its truth is a fit; may be empty.
std::string noteOf(const CompareSide& side, const MaterialSlot& shown);

/// The technique by which a side is drawn. `slot`: what orderOf was fitted to, else the shown
/// material. Functions that no renderer has as maps are drawn as `reference`.
scene::ViewTechnique techniqueOf(const CompareSide& side, const MaterialSlot& slot,
                                 scene::ViewTechnique chosen);

}  // namespace fbrdf::viewer
