#include "Module.h"

#include "PictureModule.h"

#include <fbrdf/base/Found.h>

#include <dlfcn.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>

namespace fbrdf {
namespace {

constexpr const char* kModuleFile = "fbrdf_pictures_oiio.so";

/// The module at a path, or null and the reason. A file that was opened stays open: its statics may
/// have started threads.
const fbrdf_picture_module* opened(const std::string& path, std::string& why)
{
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        why = dlerror();
        return nullptr;
    }
    const auto function = reinterpret_cast<fbrdf_picture_module_function>(
        dlsym(library, FBRDF_PICTURE_MODULE_FUNCTION));
    if (function == nullptr) {
        why = path + " is no module of fbrdf";
        return nullptr;
    }
    const fbrdf_picture_module* module = function();
    if (module->version == FBRDF_PICTURE_MODULE_VERSION) return module;
    why = path + " has version " + std::to_string(module->version) + ", not " +
          std::to_string(FBRDF_PICTURE_MODULE_VERSION);
    return nullptr;
}

}  // namespace

std::vector<std::string> pictureModulePaths()
{
    if (const char* path = std::getenv("FBRDF_PICTURES_MODULE")) return {path};
    std::error_code none;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
    if (none) return {};
    const auto path = program.parent_path() / FBRDF_PROGRAM_TO_MODULE / kModuleFile;
    return {path.lexically_normal().string()};
}

const fbrdf_picture_module& pictureModule(ErrorKind kind, const std::string& where)
{
    // Two threads may both open it: dlopen counts, and gives both the same module.
    static std::atomic<const fbrdf_picture_module*> known{nullptr};
    if (const fbrdf_picture_module* module = known.load()) return *module;
    std::string reasons;
    for (const std::string& path : pictureModulePaths()) {
        std::string why;
        if (const fbrdf_picture_module* module = opened(path, why)) {
            known.store(module);
            return *module;
        }
        reasons += (reasons.empty() ? "" : "; ") + why;
    }
    throw Error(kind, where,
                Found("no module for pictures of this format (" +
                      (reasons.empty() ? "the program's own path is unknown" : reasons) + ")")
                    .expected(std::string(kModuleFile) +
                              " of fbrdf, which needs OpenImageIO (Debian: libopenimageio-dev to "
                              "build it), or its path in FBRDF_PICTURES_MODULE"));
}

}  // namespace fbrdf
