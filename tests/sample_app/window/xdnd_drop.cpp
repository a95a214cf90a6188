// Drops files on the window of another program, as a file manager does (XDND, version 5).
// Usage: xdnd_drop WINDOW FILE...    WINDOW: its number, as xdotool prints it
// Exit codes: 0 dropped and taken, 1 refused or not answered, 2 bad usage or no display.
#include <X11/Xlib.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

namespace {

constexpr auto kPatience = std::chrono::minutes(2);  // a frame of 4,096 lights
constexpr auto kPause = std::chrono::milliseconds(5);
constexpr long kVersion = 5;

std::string uriOf(const char* file)
{
    std::string uri = "file://";
    char code[4];
    for (const char c : std::filesystem::absolute(file).string()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || std::strchr("/._-", c);
        std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(c) & 0xffu);
        uri += plain ? std::string(1, c) : code;
    }
    return uri + "\r\n";
}

class Drop {
public:
    Drop(Display* display, Window target, std::string uris)
        : display_(display),
          target_(target),
          uris_(std::move(uris)),
          source_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)),
          uriList_(atom("text/uri-list"))
    {
    }

    bool run()
    {
        XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
        tell("XdndEnter", kVersion << 24, static_cast<long>(uriList_));
        tell("XdndPosition", 0, place(), CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        if (!hears("XdndStatus")) return false;
        if ((answer_.data.l[1] & 1) == 0) return false;
        tell("XdndDrop", 0, CurrentTime);
        return hears("XdndFinished");
    }

private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    /// The middle of the target on the screen.
    long place() const
    {
        XWindowAttributes size = {};
        XGetWindowAttributes(display_, target_, &size);
        int x = 0, y = 0;
        Window child = 0;
        XTranslateCoordinates(display_, target_, DefaultRootWindow(display_), size.width / 2,
                              size.height / 2, &x, &y, &child);
        return static_cast<long>(x) << 16 | static_cast<long>(y);
    }

    void tell(const char* message, long b, long c, long d = 0, long e = 0)
    {
        XClientMessageEvent event = {};
        event.type = ClientMessage;
        event.window = target_;
        event.message_type = atom(message);
        event.format = 32;
        const long words[5] = {static_cast<long>(source_), b, c, d, e};
        std::memcpy(event.data.l, words, sizeof words);
        XSendEvent(display_, target_, False, NoEventMask, reinterpret_cast<XEvent*>(&event));
        XFlush(display_);
    }

    /// Gives the files to who asks for them, until the message has come.
    bool hears(const char* message)
    {
        const Atom wanted = atom(message);
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (std::chrono::steady_clock::now() < end) {
            if (!XPending(display_)) {
                std::this_thread::sleep_for(kPause);
                continue;
            }
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) give(event.xselectionrequest);
            if (event.type != ClientMessage || event.xclient.message_type != wanted) continue;
            answer_ = event.xclient;
            return true;
        }
        return false;
    }

    void give(const XSelectionRequestEvent& asked)
    {
        XChangeProperty(display_, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uris_.data()),
                        static_cast<int>(uris_.size()));
        XSelectionEvent reply = {};
        reply.type = SelectionNotify;
        reply.requestor = asked.requestor;
        reply.selection = asked.selection;
        reply.target = asked.target;
        reply.property = asked.property;
        reply.time = asked.time;
        XSendEvent(display_, asked.requestor, False, NoEventMask,
                   reinterpret_cast<XEvent*>(&reply));
        XFlush(display_);
    }

    Display* display_;
    Window target_;
    std::string uris_;
    Window source_;
    Atom uriList_;
    XClientMessageEvent answer_ = {};
};

}  // namespace

int main(int argc, char** argv)
{
    Display* const display = argc > 2 ? XOpenDisplay(nullptr) : nullptr;
    if (!display) {
        std::fprintf(stderr, "xdnd_drop: found no %s\n", argc <= 2 ? "window and file" : "display");
        return 2;
    }
    const Window target = std::strtoul(argv[1], nullptr, 0);
    std::string uris;
    for (int i = 2; i < argc; ++i) uris += uriOf(argv[i]);
    const bool taken = Drop(display, target, uris).run();
    XCloseDisplay(display);
    return taken ? 0 : 1;
}
