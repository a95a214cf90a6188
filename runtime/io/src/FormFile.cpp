#include <fbrdf/io/FormFile.h>

#include "Files.h"
#include "FormJson.h"

namespace fbrdf {

Form formFromJson(const std::string& text, const std::string& where)
{
    const Json parsed = parseJson(text, where);
    const JsonField json(parsed, where + ": ");
    return formFromJson(json.has("form") ? json.at("form") : json);
}

Form readForm(const std::string& path)
{
    return formFromJson(readFile(path), path);
}

}  // namespace fbrdf
