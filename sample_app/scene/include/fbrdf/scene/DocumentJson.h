// DocumentJson.h - a document as JSON. docs/scene.md describes the fields; all are optional, and
// those that are left out are as in Document.
#pragma once
#include <fbrdf/scene/Document.h>

#include <string>
#include <string_view>

namespace fbrdf::scene {

/// Throws Error(input) naming `where` (which stands for the file) and the field, for text that is
/// not JSON (with line and column), an unknown field, and a value of the wrong kind or out of
/// range. Names of files stay as they are written.
Document documentFromJson(std::string_view text, const std::string& where);

/// Inverse of documentFromJson, but for SceneMaterial::slot. Throws Error(output) for names of
/// files that are no UTF-8, which JSON cannot have.
std::string documentToJson(const Document& document);

}  // namespace fbrdf::scene
