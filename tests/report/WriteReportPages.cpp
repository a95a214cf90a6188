// Writes function.html and scattered.html into the folder named on the command line: pages for
// check_page.py, with hostile names in every place that takes text.
#include "TestMaterials.h"

#include <fbrdf/report/Report.h>

#include <exception>
#include <iostream>

namespace {

const char* const kHostile = "<script>\"'&]]></title>\xFF\x01 http://example.com/ <img src=x>";

void writePage(const fbrdf::Source& source, const fbrdf::Form& form, const std::string& path)
{
    fbrdf::Material material = fbrdf::test::constantMaterial(fbrdf::Vec3f(0.3f), form);
    material.name = kHostile;
    material.notes = {{kHostile, kHostile}};
    for (fbrdf::Table& table : material.tables) table.name = kHostile;
    fbrdf::ReportInput input{material, source};
    input.heldOutNote = input.command = kHostile;
    input.trials = {{kHostile, kHostile, 1, 2, 0.5, {{"log_rms", 0.1}, {kHostile, 0.2}}, true}};
    writeReport(input, path);
}

}  // namespace

int main(int argc, char** argv)
try {
    if (argc != 2) return 2;
    fbrdf::Source function = fbrdf::test::lambertianSource(0.2),
                  scattered = fbrdf::test::scatteredSource(0.2f);
    function.isotropic = false;
    function.name = function.description = scattered.description = kHostile;
    writePage(function, fbrdf::formPqpr(16, 0.5, 16), std::string(argv[1]) + "/function.html");
    writePage(scattered, fbrdf::formHdio({8, 4, 4}), std::string(argv[1]) + "/scattered.html");
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
