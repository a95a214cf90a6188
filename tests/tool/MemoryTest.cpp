// What reading a file takes at most: 16 bytes of memory for each of its bytes, beside what the
// program needs for any file. The files have numbers of one digit, the shortest that their format
// allows, so that they hold as many as their size can.
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/base/Number.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>

namespace fbrdf::test {
namespace {

constexpr size_t kFileSize = size_t(2) << 20;
constexpr size_t kBytesPerByte = 16;
/// The program and its libraries, and the samples that `info` keeps (SampleFacts.h). 64 MB are
/// promised; half of it is what they take, so that files of 2 MB show what larger ones would.
constexpr size_t kAnyFile = size_t(32) << 20;

std::string repeated(const std::string& text, size_t count)
{
    std::string all;
    all.reserve(text.size() * count);
    for (size_t i = 0; i < count; ++i) all += text;
    return all;
}

/// Rows of one length after a head, and before a tail.
std::string rowsBelow(const std::string& head, const std::string& row, const std::string& tail = "")
{
    return head + repeated(row, (kFileSize - head.size() - tail.size()) / row.size()) + tail;
}

/// "first first + step ..", `count` numbers.
std::string ascending(size_t count, double step)
{
    std::string text;
    for (size_t i = 0; i < count; ++i) text += numberText(double(i) * step) + " ";
    return text;
}

std::string zemax()
{
    constexpr size_t kAzimuths = 500, kRadials = kFileSize / 2 / kAzimuths - 10;
    return "SpectralContent Monochrome\nScatterType BRDF\nSampleRotation 1\n0\nAngleOfIncidence 1\n"
           "0\nScatterAzimuth " +
           std::to_string(kAzimuths) + "\n" + repeated("1 ", kAzimuths) + "\nScatterRadial " +
           std::to_string(kRadials) + "\n" + repeated("1 ", kRadials) +
           "\nMonochrome\nDataBegin\nTIS 0\n" + repeated("1 ", kAzimuths * kRadials) + "DataEnd\n";
}

std::string speosHead(const std::string& title)
{
    return "OPTIS - " + title + " v8.0\n0\na comment\n1\nm\n";
}

std::string speosOfOneTable()
{
    constexpr size_t kThetas = 500, kPhis = kFileSize / 2 / kThetas - 60;
    std::string text = speosHead("brdf surface file") + "1 0\n1\n1 1\n1\n550\n1 " +
                       std::to_string(kThetas) + " " + std::to_string(kPhis) + "\n" +
                       ascending(kPhis, 360.0 / kPhis);
    for (size_t t = 0; t < kThetas; ++t)
        text += "\n" + numberText(double(t) * 90.0 / kThetas) + " " + repeated("1 ", kPhis);
    return text;
}

/// Tables of the fewest nodes: each incidence and wavelength has one.
std::string speosOfManyTables()
{
    constexpr size_t kWavelengths = 20;
    const std::string table = "1 2 2 0 1 0 1 1 1 1 1 ";
    const size_t incidences = kFileSize / (kWavelengths * table.size() + 2);
    std::string wavelengths;
    for (size_t w = 0; w < kWavelengths; ++w) wavelengths += std::to_string(400 + w) + " ";
    return speosHead("brdf surface file") + "1 0\n1\n" + std::to_string(incidences) + " " +
           std::to_string(kWavelengths) + "\n" + repeated("1 ", incidences) + wavelengths + "\n" +
           repeated(table, incidences * kWavelengths);
}

std::string speosAnisotropic()
{
    constexpr size_t kIncidences = 9999;
    const std::string table = "2 2 0 1 0 1 1 1 1 1 ";
    const size_t turns = kFileSize / (kIncidences * (table.size() + 2));
    const std::string incidences = std::to_string(kIncidences) + " " + repeated("1 ", kIncidences);
    return speosHead("Anisotropic BSDF surface file") + "0 1 0\n1 0\n1\n" + std::to_string(turns) +
           "\n" + repeated("1 ", turns) + repeated(incidences, turns) + "1 0\ns\n1\n550 1\n" +
           repeated(table, turns * kIncidences);
}

std::string tensorTree(int depth)
{
    return depth == 0 ? "{1}" : "{" + repeated(tensorTree(depth - 1), 16) + "}";
}

std::string klems(const std::string& data)
{
    return "<WindowElement><DataDefinition><IncidentDataStructure>TensorTree4"
           "</IncidentDataStructure></DataDefinition><WavelengthData><Wavelength>Visible"
           "</Wavelength><WavelengthDataBlock><WavelengthDataDirection>Reflection Front"
           "</WavelengthDataDirection><ScatteringData>" +
           data + "</ScatteringData></WavelengthDataBlock></WavelengthData></WindowElement>";
}

/// Rows of float32, all of them 1.
std::string binaryRows(const std::string& head, size_t columns, size_t rows)
{
    const float one = 1.0f;
    std::string bytes(rows * columns * sizeof one, '\0');
    for (size_t at = 0; at < bytes.size(); at += sizeof one)
        std::memcpy(bytes.data() + at, &one, sizeof one);
    return head + bytes;
}

std::string altaHead(const std::string& dimensions, const std::string& input)
{
    return "#DIM " + dimensions + "\n#PARAM_IN " + input + "\n#PARAM_OUT INV_STERADIAN\n";
}

std::string binaryAlta()
{
    constexpr size_t kRows = kFileSize / 8;
    return binaryRows(altaHead("1 1", "COS_TH") +
                          "#FORMAT binary\n#ENDIAN little\n#PRECISION ieee754-single\n"
                          "#SAMPLE_COUNT " +
                          std::to_string(kRows) + "\n#ALTA_END_HEADER\n",
                      2, kRows);
}

std::string columns()
{
    constexpr size_t kRows = kFileSize / 20;
    return binaryRows(
        "fbrdf-columns 1\ntheta_i,phi_i,theta_o,phi_o,value\n" + std::to_string(kRows) + "\n", 5,
        kRows);
}

struct MinimalFile {
    const char* title;  ///< of the test
    const char* name;   ///< of the file
    std::function<std::string()> content;
};

std::string xompt()
{
    return rowsBelow("{\"openmaterial\":1,\"lookupTable\":[", "[1,1,1,1,1],", "[1,1,1,1,1]]}");
}

std::vector<MinimalFile> minimalFiles()
{
    const auto text = [](std::string head, std::string row) {
        return [head = std::move(head), row = std::move(row)] { return rowsBelow(head, row); };
    };
    return {
        {"Zemax", "a.bsdf", zemax},
        {"AltaOfOneCoordinate", "a.alta", text(altaHead("1 1", "COS_TH"), "1 1\n")},
        {"AltaOfTwoCoordinates", "a.alta", text(altaHead("2 1", "COS_TH_TD"), "1 1 1\n")},
        {"BinaryAlta", "a.alta", binaryAlta},
        {"Astm", "a.astm", text("VARS theta_i,theta_s,phi_s,v\n", "1 1 1 1\n")},
        {"SpeosOfOneTable", "a.brdf", speosOfOneTable},
        {"SpeosOfManyTables", "a.brdf", speosOfManyTables},
        {"SpeosAnisotropic", "a.anisotropicbsdf", speosAnisotropic},
        {"Fred", "a.txt", text("type bsdf_data\n1 1\n", "1 1 1\n")},
        {"Lumos", "a.txt", text("# phi_i theta_i phi_o theta_o brdf\n", "1 1 1 1 1\n")},
        {"Pab", "a.bme", text("#incident_angle 1 1\n#format: theta phi BRDF\n", "1 1 1\n")},
        {"Csv", "a.csv", text("theta_i,phi_i,theta_o,phi_o,value\n", "1,1,1,1,1\n")},
        {"PlanarSpectra", "a.csv", text("Incident_angle,Measure_angle,550nm\n", "1,1,1\n")},
        {"Rt300s", "a.csv", text("stage_deg,theta_i_deg,A_deg,R_deg,brdf\n", "1,1,1,9,1\n")},
        {"Nist", "a.csv", text("lambda,thetai,phi,thetar,phir,f_r\n", "1,1,1,1,1,1\n")},
        {"Cornell", "a.brdf", text("1\n550\n", "1 1 1 1 1\n")},
        {"ScatteredAngles", "a.txt", text("", "1 1 1 1 1 1 1\n")},
        {"ScatteredDirections", "a.txt", text("", "1 1 1 1 1 1 1 1 1\n")},
        {"Xompt", "a.xompt", xompt},
        {"BinaryColumns", "a.f32c", columns},
        {"TensorTreeOfLeaves", "a.xml", [] { return klems(tensorTree(4)); }},
        {"TensorTreeOfOneGrid", "a.xml", [] { return klems("{" + repeated("1 ", 1 << 20) + "}"); }},
    };
}

class MinimalFileTest : public testing::TestWithParam<MinimalFile> {};

TEST_P(MinimalFileTest, TakesSixteenTimesItsSizeAtMost)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer takes memory of its own";
#endif
    const TemporaryDir folder;
    const std::string path = folder.file(GetParam().name);
    size_t size = 0;
    {
        const std::string content = GetParam().content();
        size = content.size();
        writeText(path, content);
    }
    const size_t most = kBytesPerByte * size + kAnyFile;
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"info", path}, {"convert", path, folder.file("out.csv")}}) {
        const ToolRun run = runTool(command);
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_LT(size_t(run.maxResidentKb) << 10, most) << command.front();
    }
}

struct HostilePicture {
    const char* title;
    const char* name;
    std::string content;
    const char* words;  ///< of the error
};

std::string number(uint32_t value, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255u);
    return text;
}

/// A TIFF of black floats, R, G, B, whose strips or tiles (side x height) are all one run of
/// PackBits, 128 zeros in two bytes.
std::string blackTiff(uint32_t width, uint32_t height, uint32_t tileWidth, uint32_t tileHeight)
{
    const bool tiled = tileWidth > 0;
    const uint32_t across = tiled ? (width + tileWidth - 1) / tileWidth : 1;
    const uint32_t parts = across * ((height + tileHeight - 1) / tileHeight);
    const size_t bytes = size_t(tiled ? tileWidth : width) * tileHeight * 12;
    const std::string run = repeated(std::string("\x81\0", 2), (bytes + 127) / 128);
    const auto runAt = uint32_t(8), threeAt = uint32_t(runAt + run.size()), formatAt = threeAt + 6,
               offsetsAt = formatAt + 6, countsAt = offsetsAt + 4 * parts;
    std::string text = "II" + number(42, 2) + number(countsAt + 4 * parts, 4) + run;
    for (int i = 0; i < 3; ++i) text += number(32, 2);
    for (int i = 0; i < 3; ++i) text += number(3, 2);
    for (uint32_t i = 0; i < parts; ++i) text += number(runAt, 4);
    for (uint32_t i = 0; i < parts; ++i) text += number(uint32_t(run.size()), 4);
    std::string entries;
    uint32_t count = 0;
    const auto add = [&](uint32_t tag, int type, uint32_t values, uint32_t value) {
        entries +=
            number(tag, 2) + number(uint32_t(type), 2) + number(values, 4) + number(value, 4);
        ++count;
    };
    add(256, 4, 1, width);
    add(257, 4, 1, height);
    add(258, 3, 3, threeAt);
    add(259, 3, 1, 32773);
    add(262, 3, 1, 2);
    if (!tiled) add(273, 4, parts, parts == 1 ? runAt : offsetsAt);
    add(277, 3, 1, 3);
    if (!tiled) add(278, 4, 1, tileHeight);
    if (!tiled) add(279, 4, parts, parts == 1 ? uint32_t(run.size()) : countsAt);
    if (tiled) {
        add(322, 4, 1, tileWidth);
        add(323, 4, 1, tileHeight);
        add(324, 4, parts, parts == 1 ? runAt : offsetsAt);
        add(325, 4, parts, parts == 1 ? uint32_t(run.size()) : countsAt);
    }
    add(339, 3, 3, formatAt);
    return text + number(count, 2) + entries + number(0, 4);
}

std::string hdr(const std::string& sides)
{
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + sides + "\n";
}

std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value)
{
    return name + '\0' + type + '\0' + number(uint32_t(value.size()), 4) + value;
}

/// An OpenEXR file of one float channel whose pixels are missing, in tiles where `tile` is above 0.
std::string emptyExr(uint32_t width, uint32_t height, uint32_t tile)
{
    const std::string zero = number(0, 4), one = number(0x3f800000, 4);  // floats
    const std::string window = zero + zero + number(width - 1, 4) + number(height - 1, 4);
    const std::string y = std::string("Y\0", 2) + number(2, 4) + zero + number(1, 4) + number(1, 4);
    std::string text = "\x76\x2f\x31\x01" + number(tile > 0 ? 0x202 : 2, 4) +
                       exrAttribute("channels", "chlist", y + '\0') +
                       exrAttribute("compression", "compression", number(0, 1)) +
                       exrAttribute("dataWindow", "box2i", window) +
                       exrAttribute("displayWindow", "box2i", window) +
                       exrAttribute("lineOrder", "lineOrder", number(0, 1)) +
                       exrAttribute("pixelAspectRatio", "float", one) +
                       exrAttribute("screenWindowCenter", "v2f", zero + zero) +
                       exrAttribute("screenWindowWidth", "float", one);
    if (tile > 0)
        text += exrAttribute("tiles", "tiledesc", number(tile, 4) + number(tile, 4) + '\0');
    const size_t chunks = tile == 0 && height <= 4096 ? height : 1;  // their places in the file
    return text + '\0' + repeated(number(1, 4) + number(0, 4), chunks);
}

std::vector<HostilePicture> hostilePictures()
{
    constexpr const char* kUnreadable = "an OpenEXR file that cannot be read";
    return {
        {"OneStrip", "a.tif", blackTiff(1600, 1600, 0, 1600), "far fewer in a small file"},
        {"EqualStrips", "a.tif", blackTiff(4000, 4000, 0, 1), "far fewer in a small file"},
        {"LargeTile", "a.tif", blackTiff(64, 64, 4096, 4096), "tiles are larger than the picture"},
        {"HugeTiff", "a.tif", blackTiff(200000, 200000, 0, 1), "a picture that cannot be read"},
        {"WideHdr", "a.hdr", hdr("-Y 1 +X 2000000000"), "far fewer in a small file"},
        {"HugeHdr", "a.hdr", hdr("-Y 30000 +X 30000"), "far fewer in a small file"},
        {"LargeExr", "a.exr", emptyExr(4096, 4096, 0), "far fewer in a small file"},
        {"TallExr", "a.exr", emptyExr(1, 0x7ffffff0, 0), kUnreadable},
        {"HugeExr", "a.exr", emptyExr(0x7ffffff0, 0x7ffffff0, 0), kUnreadable},
        {"SmallTiles", "a.exr", emptyExr(4096, 4096, 1), kUnreadable},
        {"LargeTiles", "a.exr", emptyExr(64, 64, 0x4000), kUnreadable},
        {"HugeTiles", "a.exr", emptyExr(64, 64, 0xfffffff0), kUnreadable},
    };
}

class HostilePictureTest : public testing::TestWithParam<HostilePicture> {};

TEST_P(HostilePictureTest, IsRefusedInOneLineWithoutItsMemory)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer takes memory of its own";
#endif
    const TemporaryDir folder;
    // OpenImageIO and the libraries behind it are in memory by then.
    const std::string small = folder.file("small.tif"), path = folder.file(GetParam().name);
    writeText(small, blackTiff(16, 16, 0, 16));
    const ToolRun usual = runTool({"info", small});
    EXPECT_EQ(usual.code, 0) << usual.err;
    writeText(path, GetParam().content);
    const ToolRun run = runTool({"info", path});
    expectError(run, 3, GetParam().words);
    const long most = usual.maxResidentKb + long((16 * GetParam().content.size() + kAnyFile) >> 10);
    EXPECT_LT(run.maxResidentKb, most);
}

INSTANTIATE_TEST_SUITE_P(Pictures, HostilePictureTest, testing::ValuesIn(hostilePictures()),
                         [](const auto& picture) { return std::string(picture.param.title); });

std::string titleOf(const testing::TestParamInfo<MinimalFile>& file)
{
    return file.param.title;
}
INSTANTIATE_TEST_SUITE_P(Readers, MinimalFileTest, testing::ValuesIn(minimalFiles()), titleOf);

}  // namespace
}  // namespace fbrdf::test
