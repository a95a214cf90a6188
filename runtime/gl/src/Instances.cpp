#include "Instances.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf::gl {

glm::mat4 modelView(const View& view, const glm::mat4& model)
{
    return glm::mat4(glm::dmat4(view.view) * glm::dmat4(model));
}

InstanceTexels instanceTexels(const glm::mat4& modelView, int layer)
{
    FBRDF_ASSERT(layer, >=, 0);
    FBRDF_ASSERT(layer, <, 1 << 24);
    return {glm::vec4(Vec3f(modelView[0]), static_cast<float>(layer)), modelView[1], modelView[2],
            modelView[3]};
}

}  // namespace fbrdf::gl
