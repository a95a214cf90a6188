// fbrdf forms: the products that can be fitted.
#include "Commands.h"
#include "Errors.h"
#include "Output.h"
#include "TextTable.h"

#include <fbrdf/fit/Fit.h>
#include <fmt/format.h>

namespace fbrdf::tool {
namespace {

struct FormFacts {
    NamedForm named;
    Form form;
    int lookups;   ///< for each light
    size_t bytes;  ///< at the default resolution, in log8
};

size_t bytesInLog8(const Form& form)
{
    size_t texels = 0;
    for (const TableSpec& table : form.tables)
        texels += static_cast<size_t>(texelCount(table.domain));
    return texels * 3;
}

std::vector<FormFacts> facts()
{
    std::vector<FormFacts> all;
    for (const NamedForm& named : namedForms()) {
        const Form form = makeForm(named.name);
        all.push_back({named, form, lookupsPerLight(form), bytesInLog8(form)});
    }
    return all;
}

Json formsJson()
{
    Json forms = Json::array();
    for (const FormFacts& f : facts())
        forms.push_back({{"name", f.named.name},
                         {"product", f.named.product},
                         {"tables", describe(f.form)},
                         {"note", f.named.note},
                         {"isotropic", isIsotropic(f.form)},
                         {"reciprocal", f.named.isReciprocal},
                         {"lookups_per_light", f.lookups},
                         {"default_resolution", f.named.defaultResolution},
                         {"bytes", f.bytes}});
    Json made = Json::array();
    for (const NamedForm& named : directForms())
        made.push_back({{"name", named.name},
                        {"product", named.product},
                        {"note", named.note},
                        {"default_resolution", named.defaultResolution}});
    Json letters = Json::array();
    for (const FormLetter& letter : formLetters())
        letters.push_back({{"letters", letter.letters}, {"meaning", letter.meaning}});
    return {{"forms", forms}, {"made_forms", made}, {"letters", letters}};
}

std::string lettersText()
{
    std::vector<std::vector<std::string>> rows;
    for (const FormLetter& letter : formLetters()) rows.push_back({letter.letters, letter.meaning});
    return "\nLetters in the names of forms:\n" + alignedTable({Align::left, Align::left}, rows);
}

std::string formsText()
{
    std::vector<std::vector<std::string>> rows{
        {"form", "product", "look-ups a light", "resolution", "bytes", "notes"}};
    for (const FormFacts& f : facts())
        rows.push_back({f.named.name, f.named.product, fmt::format("{}", f.lookups),
                        fmt::format("{}", f.named.defaultResolution), withSeparators(f.bytes),
                        f.named.note});
    for (const NamedForm& named : directForms())
        rows.push_back({named.name, named.product, "", fmt::format("{}", named.defaultResolution),
                        "", named.note});
    const Align l = Align::left, r = Align::right;
    return alignedTable({l, l, r, r, r, l}, rows) +
           "\nResolution and bytes are the defaults, 8 bits a texel and channel. "
           "--form auto, the default of fbrdf fit,\ntries forms within the budget and keeps the "
           "one whose errors a person sees least, the cheaper of two that\nare as good; --form "
           "best-of goes on to other sizes and warps of it.\n" +
           lettersText();
}

}  // namespace

void addFormsCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("forms", "the forms that can be fitted");
    const auto json = std::make_shared<bool>(false);
    sub->add_flag("--json", *json, "print one JSON object");
    sub->callback([json, &action] {
        action = [json] {
            writeOut(*json ? text(formsJson()) : formsText());
            return 0;
        };
    });
}

}  // namespace fbrdf::tool
