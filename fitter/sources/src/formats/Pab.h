// Pab.h - a folder of pab's files is one measurement.
#pragma once
#include <fbrdf/sources/Source.h>

#include <string>

namespace fbrdf {

/// True for a folder that has a file of pab's gonio-photometer (Pab.cpp), whatever else is in it.
bool isPabFolder(const std::string& path);

/// All such files of the folder, in the order of their names. `choice`: as that of one file. Throws
/// Error(input) as the reader of one file does, naming the file.
Source readPabFolder(const std::string& path, const std::string& choice);

}  // namespace fbrdf
