#include <fbrdf/scene/BrowserView.h>
#include <fbrdf/scene/CursorView.h>

#include <algorithm>

namespace fbrdf::scene {

bool applyBrowserKey(BrowserView& browser, char key)
{
    if (key == 'y') {
        browser.focused = !browser.focused;
        browser.on = browser.on || browser.focused;
        return true;
    }
    if (!browser.on || !browser.focused) return false;
    switch (key) {
        case kLeftKey: browser.chosen = std::max(0, browser.chosen - 1); return true;
        case kRightKey:
            browser.chosen = std::max(0, std::min(browser.chosen + 1, browser.count - 1));
            return true;
        case kEnterKey: browser.open = browser.count > 0; return true;
        default: return false;
    }
}

}  // namespace fbrdf::scene
