#include <osgFbrdf/EnvironmentLight.h>

#include "EnvironmentCube.h"
#include "KeptTransforms.h"
#include "PanoramaPicture.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/environment/Prefilter.h>

#include <osg/Notify>
#include <osgUtil/GLObjectsVisitor>

#include <algorithm>

namespace osgFbrdf {
namespace {

constexpr int kMostFaceSize = 4096;

/// Of what read() returns, or null with a warning that has the reason.
template <class Read>
osg::ref_ptr<EnvironmentCube> cubeOf(Read read, int faceSize, const std::string& name)
{
    try {
        return new EnvironmentCube(std::make_shared<const fbrdf::Panorama>(read()), faceSize, name);
    } catch (const fbrdf::Error& error) {
        OSG_WARN << "osgFbrdf: " << error.what() << std::endl;
        return nullptr;
    }
}

std::string nameOf(const osg::Image& picture)
{
    return picture.getFileName().empty() ? "a picture from memory" : picture.getFileName();
}

}  // namespace

EnvironmentLight::EnvironmentLight() = default;
EnvironmentLight::~EnvironmentLight() = default;

EnvironmentLight::EnvironmentLight(const EnvironmentLight& other, const osg::CopyOp& op)
    : osg::Group(other, op),
      file_(other.file_),
      cube_(other.cube_),
      rotation_(other.rotation_),
      intensity_(other.intensity_),
      lobes_(other.lobes_),
      faceSize_(other.faceSize_)
{
}

bool EnvironmentLight::setPictureFile(const std::string& file, const osgDB::Options* options)
{
    file_ = file;
    cube_ = nullptr;
    if (!file.empty())
        cube_ = cubeOf([&] { return readPanoramaPicture(file, options); }, faceSize_, file);
    return valid();
}

bool EnvironmentLight::setPicture(const osg::Image* picture)
{
    file_ = picture ? picture->getFileName() : "";
    cube_ = nullptr;
    if (picture)
        cube_ = cubeOf([&] { return panoramaOf(*picture, nameOf(*picture)); }, faceSize_,
                       nameOf(*picture));
    return valid();
}

bool EnvironmentLight::setPanorama(const fbrdf::Panorama& panorama)
{
    const auto read = [&] {
        fbrdf::validate(panorama, "a panorama");
        return panorama.width > kMostColumns ? fbrdf::reduced(panorama, kMostColumns) : panorama;
    };
    file_.clear();
    cube_ = cubeOf(read, faceSize_, "a panorama");
    return valid();
}

const fbrdf::Panorama* EnvironmentLight::getPanorama() const
{
    return cube_ ? cube_->panorama().get() : nullptr;
}

void EnvironmentLight::setFaceSize(int size)
{
    int rounded = fbrdf::kSmallestFace;
    while (rounded < std::min(size, kMostFaceSize)) rounded *= 2;
    if (rounded == faceSize_) return;
    faceSize_ = rounded;
    if (cube_) cube_ = new EnvironmentCube(cube_->panorama(), faceSize_, cube_->getName());
}

void EnvironmentLight::traverse(osg::NodeVisitor& visitor)
{
    keepTransformsAbove(visitor);
    constexpr auto kCompiles = osgUtil::GLObjectsVisitor::COMPILE_STATE_ATTRIBUTES;
    auto* compiling = dynamic_cast<osgUtil::GLObjectsVisitor*>(&visitor);
    if (cube_ && compiling && compiling->getState() && (compiling->getMode() & kCompiles))
        cube_->compileGLObjects(*compiling->getState());
    osg::Group::traverse(visitor);
}

void EnvironmentLight::resizeGLObjectBuffers(unsigned int maxSize)
{
    osg::Group::resizeGLObjectBuffers(maxSize);
    if (cube_) cube_->resizeGLObjectBuffers(maxSize);
}

void EnvironmentLight::releaseGLObjects(osg::State* state) const
{
    osg::Group::releaseGLObjects(state);
    if (cube_) cube_->releaseGLObjects(state);
}

}  // namespace osgFbrdf
