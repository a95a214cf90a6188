#include "MaterialLobes.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/plan/Lobes.h>

#include <chrono>
#include <exception>

namespace fbrdf::gl {

MaterialLobes::MaterialLobes(const Material& material) : table_(material.lobes)
{
    if (table_.isEmpty()) material_ = std::make_shared<const Material>(material);
}

void MaterialLobes::start()
{
    whyNot_ =
        Found("lobes that are still being fitted").expected("later frames, or Renderer::prepare");
    try {
        // One thread: the others belong to the host, which is drawing.
        fit_ = std::async(std::launch::async, [material = std::move(material_)] {
            LobeFitOptions options;
            options.threads = 1;
            return fitLobes(*material, options);
        });
    } catch (const std::exception& error) {
        whyNot_ = error.what();  // there are no threads
    }
    material_.reset();
}

void MaterialLobes::take()
{
    try {
        table_ = fit_.get();
    } catch (const std::exception& error) {
        whyNot_ = error.what();
    }
}

const LobeTable* MaterialLobes::find(int most)
{
    if (material_) start();
    if (fit_.valid() && fit_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) take();
    if (table_.isEmpty()) return nullptr;
    if (most == 0 || most >= table_.lobes) return &table_;
    const auto known = fewer_.find(most);
    if (known != fewer_.end()) return &known->second;
    return &(fewer_[most] = withFewerLobes(table_, most));
}

void MaterialLobes::wait()
{
    if (material_) start();
    if (fit_.valid()) take();
}

}  // namespace fbrdf::gl
