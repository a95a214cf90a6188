#include "LobesOfMaterial.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/plan/Lobes.h>

#include <OpenThreads/ScopedLock>

#include <chrono>
#include <exception>

namespace osgFbrdf {

LobesOfMaterial::LobesOfMaterial(const fbrdf::Material& material)
{
    if (material.lobes.isEmpty())
        unfitted_ = std::make_shared<const fbrdf::Material>(material);
    else
        all_ = std::make_shared<const fbrdf::LobeTable>(material.lobes);
}

LobesOfMaterial::Table LobesOfMaterial::find(int most, std::string& whyNot)
{
    const OpenThreads::ScopedLock<OpenThreads::Mutex> lock(mutex_);
    if (unfitted_) begin();
    if (fit_.valid() && fit_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        finish();
    if (!all_)
        whyNot = failure_.empty() ? fbrdf::Found("lobes that a thread is fitting")
                                        .expected("later frames, or a file that has them")
                                  : failure_;
    if (!all_ || most == 0 || most >= all_->lobes) return all_;
    Table& fewer = fewer_[most];
    if (!fewer)
        fewer = std::make_shared<const fbrdf::LobeTable>(fbrdf::withFewerLobes(*all_, most));
    return fewer;
}

void LobesOfMaterial::begin()
{
    const auto material = std::move(unfitted_);
    try {
        fit_ = std::async(std::launch::async, [material]() -> Table {
            fbrdf::LobeFitOptions options;
            options.threads = 1;  // the others belong to the host, which is drawing
            return std::make_shared<const fbrdf::LobeTable>(fbrdf::fitLobes(*material, options));
        });
    } catch (const std::exception& error) {
        failure_ = error.what();  // there are no threads
    }
}

void LobesOfMaterial::finish()
{
    try {
        all_ = fit_.get();
    } catch (const std::exception& error) {
        failure_ = error.what();
    }
}

}  // namespace osgFbrdf
