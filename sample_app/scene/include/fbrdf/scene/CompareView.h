// CompareView.h - how two pictures of one scene, A and B, are compared: what keys and mouse change
// of it; no window here.
#pragma once
#include <string>

namespace fbrdf::scene {

enum class CompareMode {
    split,       ///< A to the left of a line, B to the right
    wipe,        ///< the same, and the line goes to and fro by itself
    flip,        ///< A and B take turns
    difference,  ///< of the sRGB codes that are shown, times a gain
    heat         ///< the largest difference of the channels, as colours with a scale
};
constexpr int kCompareModeCount = 5;

const char* compareModeName(CompareMode mode);             ///< "split", ...
CompareMode compareModeFromName(const std::string& name);  ///< throws Error(usage)
std::string compareModeNames();                            ///< "split, wipe, ..."

constexpr double kWipeSeconds = 4.0;  ///< that the line takes to and fro
constexpr double kFlipSeconds = 0.7;  ///< that A or B is seen
constexpr int kMostCompareTerms = 32;
constexpr float kLeastGain = 1.0f, kMostGain = 64.0f;

/// What is compared, and how: a part of a document.
struct Comparison {
    bool on = false;
    CompareMode mode = CompareMode::split;
    std::string a = "drawn", b = "reference";  ///< as --compare takes them
    float at = 0.5f;                           ///< of split: the share of the width that A has
    float gain = 8.0f;                         ///< of difference
    bool holds = false;                        ///< flip and wipe stand still

    bool operator==(const Comparison& other) const;
};

/// The same in a window, with the numbers that keys count through.
struct CompareView {
    bool on = false;
    CompareMode mode = CompareMode::split;
    int a = 0, b = 1, sideCount = 2;  ///< numbers of what is compared
    float at = 0.5f;                  ///< of split: the share of the width that A has
    float gain = 8.0f;                ///< of difference
    int terms = 4;                    ///< of singular values
    bool holds = false;               ///< flip and wipe stand still
    bool showsB = false;              ///< of flip, while it stands still

    /// The share of the width that A has now. seconds: since any moment.
    float lineAt(double seconds) const;
    /// True where flip shows B now.
    bool flipsToB(double seconds) const;
};

/// Applies a key, as applyKey (Controls.h).
bool applyCompareKey(CompareView& compare, char key);

}  // namespace fbrdf::scene
