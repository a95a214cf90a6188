// CursorView.h - the place of the picture that the window explains; no window here.
#pragma once

namespace fbrdf::scene {

/// Keys that have no character of their own.
constexpr char kLeftKey = 1, kRightKey = 2, kUpKey = 3, kDownKey = 4, kPageUpKey = 5,
               kPageDownKey = 6, kDeleteKey = 127;

struct CursorView {
    bool on = false;
    bool followsMouse = true;  ///< until a key moves the place
    double x = 0.5, y = 0.5;   ///< shares of width and height, from the top left
};

/// Applies a key, as applyKey (Controls.h).
bool applyCursorKey(CursorView& cursor, char key);

}  // namespace fbrdf::scene
