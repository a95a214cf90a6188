#include "Collection.h"
#include "Formats.h"
#include "formats/Pab.h"
#include "SampleSymmetry.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/MaterialSource.h>
#include <fbrdf/sources/Model.h>
#include <fbrdf/sources/OpenSource.h>

#include <filesystem>
#include <optional>
#include <utility>

namespace fbrdf {
namespace {

bool pathExists(const std::string& path)
{
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

/// Path and choice of "FILE@choice" or "FILE#choice"; the choice is empty where FILE is the whole.
struct FileSpec {
    std::string path, choice;
};

FileSpec fileSpecOf(const std::string& spec)
{
    if (pathExists(spec)) return {spec, ""};
    const size_t mark = spec.find_last_of("@#");
    if (mark != std::string::npos && mark + 1 < spec.size() && pathExists(spec.substr(0, mark)))
        return {spec.substr(0, mark), spec.substr(mark + 1)};
    return {};
}

/// True for a specification that can only be meant as a file: model names have no dot and no slash.
bool mustBeFile(const std::string& spec)
{
    return spec.substr(0, spec.find(':')).find_first_of("./\\") != std::string::npos;
}

/// What is known of samples alone.
Source completed(Source source)
{
    if (!source.isotropic && !source.evaluate) source.isotropic = hasIsotropicSamples(source);
    return source;
}

Source openFolder(const FileSpec& spec)
{
    Source source = readPabFolder(spec.path, spec.choice);
    const std::filesystem::path path = std::filesystem::absolute(spec.path).lexically_normal();
    if (source.name.empty())
        source.name = (path.has_filename() ? path : path.parent_path()).filename().string();
    return completed(std::move(source));
}

Source openFile(const FileSpec& spec, const SourceOptions& options)
{
    if (spec.choice.empty())
        if (std::optional<Material> material = readIfMaterial(spec.path))
            return sourceOfMaterial(std::make_shared<const Material>(std::move(*material)));
    if (isPabFolder(spec.path)) return openFolder(spec);
    const auto file = std::make_shared<const InputFile>(spec.path);
    const Format& format = formatOf(*file);
    if (!spec.choice.empty() && !format.takesChoice)
        throw Error(
            ErrorKind::usage, spec.path,
            Found("the choice '" + spec.choice + "'")
                .expected(std::string("none, as a ") + format.name + " file has one data set"));
    Source source = format.read({file, spec.choice, options});
    source.format = format.name;
    if (source.name.empty()) source.name = file->stem();
    return completed(std::move(source));
}

}  // namespace

Source sourceOfMaterial(std::shared_ptr<const Material> material)
{
    Source source;
    source.name = material->name;
    source.format = "material";
    source.description = describe(material->form);
    source.isotropic = isIsotropic(material->form);
    source.evaluate = [material = std::move(material)](const Vec3d& wo, const Vec3d& wi) {
        return evaluate<double>(*material, wo, wi);
    };
    return source;
}

Source openSource(const std::string& spec, const SourceOptions& options)
{
    const FileSpec file = fileSpecOf(spec);
    if (!file.path.empty()) return openFile(file, options);
    if (mustBeFile(spec))
        throw Error(ErrorKind::input, spec, Found("no such file").expected("a file or a model"));
    return makeModelSource(spec);
}

std::vector<std::string> materialsOf(const std::string& spec)
{
    const FileSpec chosen = fileSpecOf(spec);
    if (chosen.path.empty() || std::filesystem::is_directory(chosen.path) ||
        (chosen.choice.empty() && isMaterialFile(chosen.path)))
        return {spec};
    const auto file = std::make_shared<const InputFile>(chosen.path);
    const Format& format = formatOf(*file);
    if (!format.rows) return {spec};
    std::vector<std::string> specs;
    for (const std::string& choice : choicesOf({file, chosen.choice, {}}, format.rows(*file)))
        specs.push_back(chosen.path + "#" + choice);
    return specs.empty() ? std::vector<std::string>{spec} : specs;
}

}  // namespace fbrdf
