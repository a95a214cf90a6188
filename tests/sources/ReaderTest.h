// ReaderTest.h - what the tests of all readers share: files in a folder of their own, and the
// promise that every reader keeps for any bytes whatever: a Source that adds up, or Error(input).
#pragma once
#include <fbrdf/base/Error.h>
#include <fbrdf/sources/OpenSource.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace fbrdf::test {

/// A folder that is removed with its files.
class TempFolder {
public:
    enum class Place {
        disk,
        memory,  ///< where there is such a folder: for thousands of small files; may be short of
                 ///< room
    };
    explicit TempFolder(Place place = Place::disk)
    {
        static int count = 0;
        path_ = root(place) /
                ("fbrdf-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        std::filesystem::create_directories(path_);
    }
    ~TempFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string path(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path(name);
    }

private:
    static std::filesystem::path root(Place place)
    {
        const std::filesystem::path memory = "/dev/shm";
        const bool usable = ::access(memory.c_str(), W_OK | X_OK) == 0;
        return place == Place::memory && usable ? memory : std::filesystem::temp_directory_path();
    }

    std::filesystem::path path_;
};

/// Pairs at which the data sets' own readers (parse.py, numpy) printed the reference values.
struct ReferencePair {
    Vec3d wo, wi;
};
constexpr size_t kReferencePairs = 3;
inline ReferencePair referencePair(size_t index)
{
    const ReferencePair pairs[kReferencePairs] = {{{-0.36, 0.48, 0.8}, {0.6, 0.0, 0.8}},
                                                  {{0.6, 0.0, 0.8}, {0.0, 0.6, 0.8}},
                                                  {{0.48, -0.36, 0.8}, {-0.48, 0.36, 0.8}}};
    return pairs[index];
}

inline void expectReference(const Source& source, const Vec3d (&expected)[kReferencePairs],
                            double relative)
{
    for (size_t i = 0; i < kReferencePairs; ++i) {
        const ReferencePair pair = referencePair(i);
        const Vec3d f = source.evaluate(pair.wo, pair.wi);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(f[c], expected[i][c], relative * std::abs(expected[i][c]))
                << source.name << " pair " << i << " channel " << c;
    }
}

/// Native bytes of a number, as little-endian formats store it.
template <class T>
void append(std::string& bytes, T value)
{
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
}

inline std::vector<Sample> allSamples(const Source& source)
{
    std::vector<Sample> samples;
    forEachBlock(source, [&](const Sample* block, size_t count) {
        samples.insert(samples.end(), block, block + count);
    });
    return samples;
}

/// Every sample can be used by a fitter, and every row is accounted for.
inline void expectSound(const Source& source)
{
    const std::vector<Sample> samples = allSamples(source);
    const SampleReport report = reportOf(source);
    EXPECT_EQ(report.given,
              samples.size() + report.nonFinite + report.belowHorizon + report.invalid);
    size_t unsound = 0;
    for (const Sample& s : samples) {
        const bool finite = std::isfinite(s.f.x) && std::isfinite(s.f.y) && std::isfinite(s.f.z);
        const bool unit = std::abs(glm::length(s.wo) - 1.0f) < 1e-5f &&
                          std::abs(glm::length(s.wi) - 1.0f) < 1e-5f;
        unsound += !finite || !unit || s.wo.z <= 0.0f || s.wi.z <= 0.0f || !(s.weight >= 0.0f);
    }
    EXPECT_EQ(unsound, 0u);
    EXPECT_TRUE(source.evaluate || !samples.empty());
    if (!source.evaluate) return;
    for (const Vec3d& w : {Vec3d(0, 0, 1), Vec3d(0.6, 0, 0.8), Vec3d(0, 1, 0)}) {
        const Vec3d f = source.evaluate(w, Vec3d(0.0, -0.6, 0.8));
        EXPECT_TRUE(std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z));
    }
}

/// What the data set's own parse.py (numpy) prints of a real file.
struct RealFile {
    const char* path;  ///< below the data folder, with a choice if any
    uint64_t given;
    size_t usable;
    Sample brightest;  ///< of all usable samples, by red
};

inline void expectRealFile(const Source& source, const RealFile& file)
{
    expectSound(source);
    const std::vector<Sample> samples = allSamples(source);
    EXPECT_EQ(reportOf(source).given, file.given) << file.path;
    ASSERT_EQ(samples.size(), file.usable) << file.path;
    const Sample* brightest = samples.data();
    for (const Sample& s : samples)
        if (s.f.x > brightest->f.x) brightest = &s;
    EXPECT_LT(glm::length(brightest->wo - file.brightest.wo), 1e-6f) << file.path;
    EXPECT_LT(glm::length(brightest->wi - file.brightest.wi), 1e-6f) << file.path;
    EXPECT_NEAR(brightest->f.x, file.brightest.f.x, 1e-6f * file.brightest.f.x) << file.path;
}

/// The kind and message of the error that opening raises; kind 0 when it succeeds.
struct Outcome {
    int kind = 0;
    std::string message;
};

inline Outcome outcomeOf(const std::string& spec, const SourceOptions& options = {})
{
    try {
        expectSound(openSource(spec, options));
        return {};
    } catch (const Error& error) {
        return {static_cast<int>(error.kind()), error.what()};
    }
}

/// Expects Error(input) whose message contains `part`.
inline void expectInputError(const std::string& spec, const std::string& part)
{
    const Outcome outcome = outcomeOf(spec);
    EXPECT_EQ(outcome.kind, static_cast<int>(ErrorKind::input)) << spec;
    EXPECT_NE(outcome.message.find(part), std::string::npos) << outcome.message;
}

/// Opens prefixes of a file, every `step` bytes: each is sound or Error(input). Returns how many
/// were refused.
inline size_t refusedPrefixes(const std::string& name, const std::string& bytes, size_t step = 1)
{
    const TempFolder folder(TempFolder::Place::memory);
    size_t refused = 0;
    for (size_t length = 0; length < bytes.size(); length += step) {
        const Outcome outcome = outcomeOf(folder.write(name, bytes.substr(0, length)));
        EXPECT_TRUE(outcome.kind == 0 || outcome.kind == static_cast<int>(ErrorKind::input))
            << "prefix of " << length << " bytes: " << outcome.message;
        refused += outcome.kind != 0;
    }
    return refused;
}

/// Opens the file with each of its bytes replaced, every `step` bytes: sound or Error(input).
inline void expectSurvivesDamage(const std::string& name, const std::string& bytes, size_t step = 1)
{
    const TempFolder folder(TempFolder::Place::memory);
    for (size_t i = 0; i < bytes.size(); i += step) {
        for (const char damage : {'\0', '\xff', '-', '9'}) {
            std::string damaged = bytes;
            damaged[i] = damage;
            const Outcome outcome = outcomeOf(folder.write(name, damaged));
            EXPECT_TRUE(outcome.kind == 0 || outcome.kind == static_cast<int>(ErrorKind::input))
                << "byte " << i << ": " << outcome.message;
        }
    }
}

}  // namespace fbrdf::test
