#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/plan/Triangulate.h>
#include <fbrdf/scene/ObjFile.h>
#include <fbrdf/scene/TextFile.h>
#include <fbrdf/scene/VertexFrames.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <tuple>

namespace fbrdf::scene {
namespace {

constexpr int kAbsent = -1;
// Ear clipping is cubic in the worst case: a hostile face of this size takes seconds, not hours.
constexpr size_t kMaxCorners = 2048;

/// Indices of one corner of a face, from 0; kAbsent where the file gives none.
struct Corner {
    int position = kAbsent, texture = kAbsent, normal = kAbsent;
    bool operator<(const Corner& other) const
    {
        return std::tie(position, texture, normal) <
               std::tie(other.position, other.texture, other.normal);
    }
};

struct ObjData {
    std::vector<Vec3f> positions, normals, tangents;
    std::vector<glm::vec2> textures;
    std::vector<Corner> triangles;  ///< three a triangle
};

/// Words of one line, with errors that name it.
class Line {
public:
    Line(const std::string& text, std::string where) : words_(text), where_(std::move(where)) {}

    std::string word()
    {
        std::string text;
        words_ >> text;
        return text;
    }

    float number(const char* what) { return numberFromText(word(), what); }

    float numberFromText(const std::string& text, const char* what) const
    {
        float value = 0.0f;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
            fail(Found(text.empty() ? "the end of the line" : "'" + text + "'")
                     .expected(std::string("a finite number for ") + what));
        return value;
    }

    Vec3f vector(const char* what)
    {
        const float x = number(what), y = number(what), z = number(what);
        return {x, y, z};
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error(ErrorKind::input, where_, what);
    }

private:
    std::istringstream words_;
    std::string where_;
};

/// "3", or "-1" for the last one so far, as an index from 0.
int indexFromText(const Line& line, std::string_view text, size_t count, const char* what)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string quoted = "'" + std::string(text) + "'";
    if (error != std::errc() || end != text.data() + text.size())
        line.fail(Found(quoted).expected(std::string("the index of a ") + what));
    const int64_t limit = static_cast<int64_t>(count);
    const int64_t index = value > 0 ? int64_t(value) - 1 : limit + value;
    if (value == 0 || index < 0 || index >= limit)
        line.fail(Found(quoted).expected(std::string("a ") + what + " among the " +
                                         std::to_string(count) + " so far"));
    return static_cast<int>(index);
}

/// "v", "v/vt", "v//vn" or "v/vt/vn".
Corner cornerFromText(const Line& line, const std::string& text, const ObjData& data)
{
    const size_t first = text.find('/');
    const size_t second = first == std::string::npos ? first : text.find('/', first + 1);
    const std::string_view view(text);
    const auto part = [&](size_t begin, size_t end) {
        return begin == std::string::npos ? std::string_view()
                                          : view.substr(begin + 1, end - begin - 1);
    };
    Corner corner;
    corner.position = indexFromText(line, view.substr(0, first), data.positions.size(), "position");
    if (const auto texture = part(first, second); !texture.empty())
        corner.texture = indexFromText(line, texture, data.textures.size(), "texture coordinate");
    if (const auto normal = part(second, text.size()); !normal.empty())
        corner.normal = indexFromText(line, normal, data.normals.size(), "normal");
    return corner;
}

void readFace(Line& line, ObjData& data)
{
    std::vector<Corner> corners;
    std::vector<Vec3d> outline;
    for (std::string text = line.word(); !text.empty(); text = line.word()) {
        corners.push_back(cornerFromText(line, text, data));
        outline.emplace_back(data.positions[static_cast<size_t>(corners.back().position)]);
    }
    if (corners.size() < 3 || corners.size() > kMaxCorners)
        line.fail(Found("a face of " + std::to_string(corners.size()) + " corners")
                      .expected("3 to " + std::to_string(kMaxCorners)));
    for (const auto& triangle : triangulate(outline))
        for (const int corner : triangle)
            data.triangles.push_back(corners[static_cast<size_t>(corner)]);
}

void readLine(Line& line, ObjData& data)
{
    const std::string keyword = line.word();
    if (keyword == "v") {
        data.positions.push_back(line.vector("a position"));
    } else if (keyword == "vn") {
        data.normals.push_back(line.vector("a normal"));
    } else if (keyword == "r") {
        data.tangents.push_back(line.vector("a tangent"));
    } else if (keyword == "vt") {
        const float u = line.number("a texture coordinate");
        const std::string rest = line.word();  // v is optional, and so is a third coordinate
        data.textures.emplace_back(u, rest.empty() ? 0.0f : line.numberFromText(rest, "its v"));
    } else if (keyword == "f") {
        readFace(line, data);
    }
}

/// Calls readLine for every line of the text; a line that ends with a backslash goes on.
void readLines(std::string_view text, const std::string& where, ObjData& data)
{
    std::istringstream input{std::string(text)};
    std::string line, more;
    int number = 0;
    while (std::getline(input, line)) {
        const int first = ++number;
        while (!line.empty() && line.back() == '\\' && std::getline(input, more)) {
            line.back() = ' ';
            line += more;
            ++number;
        }
        Line words(line.substr(0, line.find('#')), where + ":" + std::to_string(first));
        readLine(words, data);
    }
}

/// The vertices of the mesh: one for each different corner.
struct Vertices {
    Mesh mesh;
    std::vector<Corner> corners;
};

Vertices weld(const ObjData& data)
{
    Vertices out;
    std::map<Corner, uint32_t> known;
    for (const Corner& corner : data.triangles) {
        const auto [entry, isNew] =
            known.emplace(corner, static_cast<uint32_t>(out.corners.size()));
        if (isNew) {
            out.corners.push_back(corner);
            out.mesh.positions.push_back(data.positions[static_cast<size_t>(corner.position)]);
        }
        out.mesh.indices.push_back(entry->second);
    }
    return out;
}

/// Normals of the file, unit; smooth ones where it has none or one of no length.
void fillNormals(const ObjData& data, Vertices& vertices)
{
    std::vector<uint32_t> shared;  // smoothing ignores splits by texture coordinate
    for (const Corner& corner : data.triangles)
        shared.push_back(static_cast<uint32_t>(corner.position));
    const std::vector<Vec3f> smooth = smoothNormals(data.positions, shared);
    for (const Corner& corner : vertices.corners) {
        Vec3f normal = smooth[static_cast<size_t>(corner.position)];
        if (corner.normal != kAbsent) {
            const Vec3d given(data.normals[static_cast<size_t>(corner.normal)]);
            if (const double length = glm::length(given); length > 0.0)
                normal = Vec3f(given / length);
        }
        vertices.mesh.normals.push_back(normal);
    }
}

/// Tangents of the file's `r` lines, made orthogonal. They follow vn, or v where there are no vn.
void fillTangents(const ObjData& data, Vertices& vertices)
{
    const bool byNormal = !data.normals.empty();
    for (size_t i = 0; i < vertices.corners.size(); ++i) {
        const Corner& corner = vertices.corners[i];
        const int index = byNormal ? corner.normal : corner.position;
        const Vec3f given =
            index == kAbsent ? Vec3f(0.0f) : data.tangents[static_cast<size_t>(index)];
        vertices.mesh.tangents.push_back(orthogonalTangent(given, vertices.mesh.normals[i]));
    }
}

/// Tangents along growing u.
void makeTangents(const ObjData& data, Vertices& vertices)
{
    std::vector<glm::vec2> textures;
    for (const Corner& corner : vertices.corners)
        textures.push_back(corner.texture == kAbsent
                               ? glm::vec2(0.0f)
                               : data.textures[static_cast<size_t>(corner.texture)]);
    computeTangents(vertices.mesh, textures);
}

void checkTangentCount(const ObjData& data, const std::string& where)
{
    const size_t expected = data.normals.empty() ? data.positions.size() : data.normals.size();
    if (data.tangents.empty() || data.tangents.size() == expected) return;
    throw Error(ErrorKind::input, where,
                Found(std::to_string(data.tangents.size()) + " tangents (r lines)")
                    .expected(std::to_string(expected) + ", one for each " +
                              (data.normals.empty() ? "v" : "vn")));
}

}  // namespace

Mesh parseObj(std::string_view text, const std::string& where)
{
    ObjData data;
    readLines(text, where, data);
    if (data.triangles.empty())
        throw Error(ErrorKind::input, where, Found("no face").expected("a Wavefront OBJ mesh"));
    checkTangentCount(data, where);
    Vertices vertices = weld(data);
    fillNormals(data, vertices);
    if (data.tangents.empty())
        makeTangents(data, vertices);
    else
        fillTangents(data, vertices);
    return std::move(vertices.mesh);
}

Mesh readObj(const std::string& path)
{
    return parseObj(readText(path, "a mesh (sphere, knot, plane or an OBJ file)"), path);
}

}  // namespace fbrdf::scene
