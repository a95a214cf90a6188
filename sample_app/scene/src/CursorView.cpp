#include <fbrdf/scene/CursorView.h>

#include <algorithm>

namespace fbrdf::scene {
namespace {

constexpr double kCursorStep = 1.0 / 128.0;  // of the window, a press

void move(CursorView& cursor, double right, double down)
{
    cursor.followsMouse = false;
    cursor.x = std::clamp(cursor.x + kCursorStep * right, 0.0, 1.0);
    cursor.y = std::clamp(cursor.y + kCursorStep * down, 0.0, 1.0);
}

}  // namespace

bool applyCursorKey(CursorView& cursor, char key)
{
    if (key == 'i') {
        cursor.on = !cursor.on;
        cursor.followsMouse = true;
        return true;
    }
    if (!cursor.on) return false;
    switch (key) {
        case kLeftKey: move(cursor, -1.0, 0.0); return true;
        case kRightKey: move(cursor, 1.0, 0.0); return true;
        case kUpKey: move(cursor, 0.0, -1.0); return true;
        case kDownKey: move(cursor, 0.0, 1.0); return true;
        default: return false;
    }
}

}  // namespace fbrdf::scene
