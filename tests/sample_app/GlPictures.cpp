#include "GlPictures.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Offscreen.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

HeadlessOptions contextOptions(Backend backend)
{
    HeadlessOptions options;
    options.backend = backend;
    return options;
}

gl::RendererOptions rendererOptions(const HeadlessContext& context)
{
    gl::RendererOptions options;
    options.load = context.loader();
    options.log = [](gl::Severity severity, const std::string& text) {
        if (severity != gl::Severity::note) ADD_FAILURE() << "renderer: " << text;
    };
    return options;
}

/// log2 of a lobe about the normal, narrower along y, on a coloured floor.
double logLobe(const Vec3d& direction, int channel)
{
    const double sharp =
        -18.0 * direction.x * direction.x - 40.0 * direction.y * direction.y - 4.0 * direction.x;
    return std::log2(std::exp2(sharp) + 0.02 * (1 + channel));
}

/// log2 F of a disc texel.
double discValue(const DiscDomain& domain, int x, int y, int channel)
{
    return logLobe(directionFromDiscPosition(domain, {double(x), double(y)}), channel);
}

/// log2 F of a grid texel: falls with the first angle and bends with the others.
double gridValue(double u, double v, int channel, bool symmetric)
{
    if (symmetric) return -0.4 * (u + v) - 0.3 * u * v * (1 + channel);
    return std::log2(std::exp2(-9.0 * u) + 0.03 * (1 + channel)) + 0.8 * v * v;
}

Table madeTable(const TableSpec& spec)
{
    Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    const auto size = domainSize(spec.domain);
    const auto unit = [](int i, int count) { return count > 1 ? double(i) / (count - 1) : 0.0; };
    for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto* disc = std::get_if<DiscDomain>(&spec.domain);
                const auto* grid = std::get_if<GridDomain>(&spec.domain);
                table.texels.push_back(static_cast<float>(
                    disc ? discValue(*disc, x, y, c)
                         : gridValue(unit(x, size[0]), unit(y, size[1]), c, grid->symmetric)));
            }
    return spec.uniform ? table : quantized(table, Storage::log8);
}

}  // namespace

GlPictures::GlPictures(Backend backend)
    : context_(contextOptions(backend)), renderer_(rendererOptions(context_))
{
}

GlPicture GlPictures::draw(const Scene& scene, const Material& material, Technique technique,
                           int width, int height)
{
    context_.makeCurrent();
    const auto gpuMaterial = renderer_.createMaterial(material);
    std::vector<std::shared_ptr<gl::GpuMesh>> meshes;
    std::vector<gl::Item> items;
    for (const Instance& instance : scene.instances) {
        meshes.push_back(renderer_.createMesh(*instance.mesh));
        items.push_back({gpuMaterial.get(), meshes.back().get(), instance.model});
    }
    Offscreen offscreen(context_.loader(), {width, height});
    offscreen.clear();
    gl::DrawOptions options;
    options.technique = technique;
    GlPicture picture{Image(width, height), {}};
    picture.stats = renderer_.draw({offscreen.framebuffer(), width, height}, scene.view, items,
                                   scene.lights, options);
    const std::vector<float> rows = offscreen.readPixels();  // from the bottom
    const std::ptrdiff_t row = 4 * std::ptrdiff_t(width);
    for (int y = 0; y < height; ++y)
        std::copy_n(rows.begin() + row * (height - 1 - y), row,
                    picture.image.rgba.begin() + row * y);
    return picture;
}

bool hasBackend(Backend backend)
{
    try {
        const HeadlessContext context(contextOptions(backend));
        return true;
    } catch (const Error&) {
        return false;
    }
}

Material madeMaterial(const Form& form)
{
    Material material;
    material.form = form;
    material.name = form.name;
    for (const TableSpec& spec : form.tables) material.tables.push_back(madeTable(spec));
    material.scales.assign(form.terms.size(), Vec3f(0.9f, 0.7f, 0.5f));
    return material;
}

Brdf brdfOf(const Material& material)
{
    return [&material](const Vec3d& wo, const Vec3d& wi) {
        return evaluate<double>(material, wo, wi);
    };
}

}  // namespace fbrdf::scene
