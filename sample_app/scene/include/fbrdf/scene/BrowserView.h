// BrowserView.h - the list of materials that one chooses from; no window here.
#pragma once

namespace fbrdf::scene {

constexpr char kEnterKey = 13;

struct BrowserView {
    bool on = false;
    bool focused = false;  ///< keys choose
    int chosen = 0, count = 0;
    bool open = false;  ///< a wish: show what is chosen
};

/// Applies a key, as applyKey (Controls.h).
bool applyBrowserKey(BrowserView& browser, char key);

}  // namespace fbrdf::scene
