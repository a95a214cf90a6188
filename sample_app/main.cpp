// fbrdf-viewer: shows factored materials, and what they are judged by. See README.md.
#include "viewer/CommandLine.h"
#include "viewer/CompareDrawing.h"
#include "viewer/CompareSheet.h"
#include "viewer/CpuDrawing.h"
#include "viewer/Figures.h"
#include "viewer/Headless.h"
#include "viewer/LeanHeap.h"
#include "viewer/Sheet.h"
#include "viewer/Turntable.h"
#include "viewer/WindowLoop.h"

#include <fbrdf/base/OutputFile.h>

#include <fmt/core.h>

namespace {

using namespace fbrdf;

/// False where one picture is asked for.
bool wroteSeveral(const viewer::Options& options, viewer::World& world)
{
    if (options.command == viewer::Command::turntable)
        viewer::writeTurntable(options, world);
    else if (options.command == viewer::Command::sheet)
        writeImage(viewer::drawSheet(options, world), options.out, options.document.exposure,
                   transferOf(options.document));
    else if (options.command == viewer::Command::compare)
        viewer::writeCompareSheet(options, world);
    else if (!options.compare.empty() && options.headless)
        viewer::writeComparison(options, world);
    else
        return false;
    return true;
}

int run(int argc, char** argv)
{
    // 1. What is asked for.
    const viewer::Options options = viewer::optionsFromArguments(argc, argv);
    if (!options.help.empty()) {
        fmt::print("{}", options.help);
        return 0;
    }
    if (options.listDevices) {
        fmt::print("{}", viewer::devicesText());
        return 0;
    }
    if (options.command == viewer::Command::figures) {
        viewer::writeFigures(options);
        return 0;
    }
    if (!options.out.empty() && options.command != viewer::Command::turntable)
        requireWritable(options.out);
    if (!options.stats.empty()) requireWritable(options.stats);
    if (!options.headless) viewer::keepHeapLean();

    // 2. Materials, mesh, lights and camera.
    viewer::World world;
    viewer::loadWorld(options, world);

    // 3. Several pictures: in one sheet, turning, or two that are compared.
    if (wroteSeveral(options, world)) return 0;

    // 4. One picture: in a window, by the runtime without one, or on the CPU.
    viewer::Picture picture;
    if (!options.headless)
        picture = viewer::runWindow(options, world);
    else if (isOnCpu(options.document.technique))
        picture = viewer::drawOnCpu(options, world);
    else
        picture = viewer::drawHeadless(options, world);

    // 5. What is kept of it.
    picture.stats.coveredPixels = viewer::coveredPixels(picture.image);
    if (!picture.isShown) viewer::addBackground(options, world, picture.view, picture.image);
    if (!options.out.empty())
        writeImage(picture.image, options.out, picture.isShown ? 1.0f : options.document.exposure,
                   picture.isShown ? Transfer::srgb : transferOf(options.document));
    if (!options.stats.empty()) writeFile(options.stats, scene::statsToJson(picture.stats));
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return fbrdf::viewer::exitCodeOf("fbrdf-viewer", run, argc, argv);
}
