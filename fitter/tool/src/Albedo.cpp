#include "Albedo.h"

#include "TextTable.h"

#include <fbrdf/base/Parallel.h>
#include <fmt/format.h>

namespace fbrdf::tool {

std::vector<AlbedoAt> albedoTable(const BrdfFunction& brdf, int threads)
{
    std::vector<AlbedoAt> table;
    for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0})
        table.push_back({degrees, Vec3d(0.0)});
    parallelTasks(table.size(), threads, [&](size_t i) {
        table[i].albedo = directionalAlbedo(brdf, table[i].degrees * kPi / 180.0);
    });
    return table;
}

Json jsonOf(const std::vector<AlbedoAt>& table)
{
    Json json = Json::array();
    for (const AlbedoAt& at : table)
        json.push_back({{"theta_i_degrees", at.degrees}, {"rgb", jsonOf(at.albedo)}});
    return json;
}

std::string textOf(const std::vector<AlbedoAt>& table)
{
    std::vector<std::vector<std::string>> rows{{"theta_i", "red", "green", "blue"}};
    for (const AlbedoAt& at : table)
        rows.push_back({fmt::format("{:.0f}", at.degrees), fmt::format("{:.4f}", at.albedo.x),
                        fmt::format("{:.4f}", at.albedo.y), fmt::format("{:.4f}", at.albedo.z)});
    return "  directional albedo\n" +
           alignedTable({Align::right, Align::right, Align::right, Align::right}, rows, 4);
}

}  // namespace fbrdf::tool
