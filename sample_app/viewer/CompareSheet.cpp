#include "CompareSheet.h"

#include "CompareDrawing.h"
#include "ComparePicture.h"
#include "HeatScale.h"
#include "LabelFont.h"
#include "SheetLayout.h"

#include <fbrdf/base/OutputFile.h>

#include <algorithm>
#include <utility>

namespace fbrdf::viewer {
namespace {

struct Column {
    std::string title;
    scene::Image image;  ///< with background
    scene::CompareStats stats;
};

std::vector<std::string> sidesOf(const Options& options, const MaterialSlot& shown)
{
    if (!options.compare.empty()) return options.compare;
    std::vector<std::string> sides{"reference", "drawn"};
    for (const CompareSide& side : offeredSides())
        for (const char* usual : {"pqp-2001", "svd4", "ggx", "ggx2"})
            if (side.name == usual && whyNot(side, shown).empty()) sides.push_back(side.name);
    return sides;
}

/// Its numbers are of what has no background, so a column is compared when it is drawn.
std::vector<Column> columnsOf(const Options& options, World& world, const Exposing& exposing)
{
    std::vector<Column> columns;
    DrawnSide first;
    for (const std::string& name : sidesOf(options, world.materials.front())) {
        const CompareSide side = compareSideFromName(name);
        DrawnSide drawn = drawnSide(side, options, world);
        if (columns.empty()) first = drawn;
        Column column{titleOf(side), {}, {drawn.stats, first.stats, "sheet", {}}};
        column.stats.numbers = compareNumbers(drawn.picture.image, first.picture.image, exposing);
        addBackground(options, world, drawn.picture.view, drawn.picture.image);
        column.image = std::move(drawn.picture.image);
        columns.push_back(std::move(column));
    }
    return columns;
}

scene::Image sheetOf(const Options& options, const std::vector<Column>& columns,
                     const Exposing& exposing)
{
    const LabelFont font(std::max(1, options.width / kPixelsPerScale));
    const SheetLayout layout{static_cast<int>(columns.size()), 2, options.width, options.height,
                             font.height() + font.height() / 2};
    checkLayout(layout);
    scene::Image sheet = paperOf(layout, kSheetPaper);
    const auto label = [&](int column, int row, const std::string& text) {
        const int top = layout.top(row) + layout.height + font.height() / 4;
        font.draw(sheet, {layout.left(column), top, layout.width}, text, kSheetInk);
    };
    for (int i = 0; i < layout.columns; ++i) {
        const Column& column = columns[static_cast<size_t>(i)];
        paste(shownCodes(column.image, exposing), layout.left(i), layout.top(0), sheet);
        label(i, 0, column.title);
        if (i == 0) continue;
        paste(heatMap(column.image, columns[0].image, exposing.exposure, exposing.transfer),
              layout.left(i), layout.top(1), sheet);
        label(i, 1, numbersText(column.stats.numbers));
    }
    return sheet;
}

}  // namespace

void writeCompareSheet(const Options& options, World& world)
{
    const Exposing exposing{options.document.exposure, transferOf(options.document)};
    const std::vector<Column> columns = columnsOf(options, world, exposing);
    writeImage(sheetOf(options, columns, exposing), options.out, 1.0f);
    if (options.stats.empty()) return;
    std::vector<scene::CompareStats> stats;
    for (const Column& column : columns) stats.push_back(column.stats);
    writeFile(options.stats, scene::compareToJson(stats));
}

}  // namespace fbrdf::viewer
