// PanoramaPicture.h - pictures of OpenSceneGraph as panoramas.
#pragma once
#include <fbrdf/environment/Panorama.h>

#include <osg/Image>
#include <osgDB/Options>

#include <string>

namespace osgFbrdf {

/// Twice as many texels as there are around a cube of faces of 512.
constexpr int kMostColumns = 4096;

/// Throws fbrdf::Error(input) naming `where` for a picture that EnvironmentLight::setPicture does
/// not take. One of more than mostColumns is made smaller.
fbrdf::Panorama panoramaOf(const osg::Image& picture, const std::string& where,
                           int mostColumns = kMostColumns);

/// What EnvironmentLight::setPictureFile takes. Throws fbrdf::Error(input) naming the file.
fbrdf::Panorama readPanoramaPicture(const std::string& file, const osgDB::Options* options);

}  // namespace osgFbrdf
