// PanelCompare.h - the sections of the panel that compare two pictures and explain a place, drawn
// with Dear ImGui between its NewFrame and Render.
#pragma once
#include "CompareStage.h"
#include "CursorInspector.h"

#include <fbrdf/scene/Controls.h>

namespace fbrdf::viewer {

/// Fields, numbers, and what lies over the picture: the line, names and the scale of heat.
void drawCompare(scene::CompareView& compare, const CompareFacts& facts);
/// Takes the place of the mouse, and draws what is there.
void drawCursor(scene::CursorView& cursor, const CursorFacts& facts);

}  // namespace fbrdf::viewer
