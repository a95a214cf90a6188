#include <fbrdf/io/FormFile.h>

#include "Files.h"
#include "FormJson.h"

namespace fbrdf {

Form readForm(const std::string& path)
{
    const Json parsed = parseJson(readFile(path), path);
    const JsonField json(parsed, path + ": ");
    return formFromJson(json.has("form") ? json.at("form") : json);
}

}  // namespace fbrdf
