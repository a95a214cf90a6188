// Module.h - the module of PictureModule.h: where it is looked for, and its one opening.
#pragma once
#include <fbrdf/base/Error.h>

#include <string>
#include <vector>

struct fbrdf_picture_module;

namespace fbrdf {

/// Paths of the module in the order in which they are tried: FBRDF_PICTURES_MODULE alone where that
/// variable is set, else the folder lib/fbrdf beside that of the program.
std::vector<std::string> pictureModulePaths();

/// The module, opened by the first call that succeeds and never closed. Throws Error(kind) naming
/// `where`, the paths that were tried and what the module needs.
const fbrdf_picture_module& pictureModule(ErrorKind kind, const std::string& where);

}  // namespace fbrdf
