// Program.h - runs fbrdf-viewer as a user does, and its pictures and stats.
#pragma once
#include <fbrdf/scene/Image.h>

#include <nlohmann/json.hpp>

#include <string>

namespace fbrdf::scene {

struct ProgramResult {
    int exitCode = -1;  ///< -1: it did not end by itself
    std::string out, err;
};

/// Runs `PREFIX PROGRAM ARGUMENTS` with the shell; prefix: variables or a wrapper.
ProgramResult runProgram(const std::string& program, const std::string& arguments,
                         const std::string& prefix = "");

/// Path of fbrdf-viewer in the build folder.
std::string viewerPath();
ProgramResult runViewer(const std::string& arguments, const std::string& prefix = "");

/// An EXR that the viewer wrote. Throws std::runtime_error.
Image readExr(const std::string& path);

nlohmann::json readJson(const std::string& path);

/// True where the shell finds the command.
bool hasCommand(const std::string& name);

}  // namespace fbrdf::scene
