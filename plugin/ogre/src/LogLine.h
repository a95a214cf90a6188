// LogLine.h - what goes wrong, as one line in OGRE's log.
#pragma once
#include <string>

namespace ogreFbrdf {

/// Writes "ogreFbrdf: WHERE: PROBLEM" as a warning.
void warn(const std::string& where, const std::string& problem);

}  // namespace ogreFbrdf
