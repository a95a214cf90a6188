#include <fbrdf/gl/Handles.h>

#include "LibraryResources.h"
#include "MeshResources.h"

namespace fbrdf::gl {

const std::string& GpuMaterial::name() const
{
    return resources_->name();
}

const std::string& GpuMaterial::whyNotRecombined() const
{
    return resources_->whyNotRecombined();
}

double GpuMaterial::filterError() const
{
    return resources_->filterError();
}

double GpuMaterial::lookUpError() const
{
    return resources_->lookUpError();
}

const Sphere& GpuMesh::bounds() const
{
    return resources_->bounds();
}

size_t GpuLibrary::size() const
{
    return resources_->places().size();
}

const std::string& GpuLibrary::whyNotPacked() const
{
    return resources_->whyNotPacked();
}

}  // namespace fbrdf::gl
