// Matrices.h - OGRE's matrices, whose rows come first, as glm's, whose columns do.
#pragma once
#include <OgreMatrix4.h>

#include <glm/mat4x4.hpp>

namespace ogreFbrdf {

inline glm::mat4 matrixOf(const Ogre::Matrix4& m)
{
    glm::mat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result[column][row] = m[static_cast<size_t>(row)][static_cast<size_t>(column)];
    return result;
}

}  // namespace ogreFbrdf
