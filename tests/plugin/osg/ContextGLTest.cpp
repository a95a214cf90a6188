// Checks that the contexts of the other tests are those that were asked for.
#include "EffectTest.h"

#include <dlfcn.h>

#include <cstdlib>
#include <sstream>
#include <string>

namespace fbrdf::test {
namespace {

using Context = EffectTest;

TEST_F(Context, IsThatOfTheBackendWhichTheEnvironmentNames)
{
    const char* name = std::getenv("FBRDF_OSG_BACKEND");
    using CurrentContext = void* (*)();
    const auto current =
        reinterpret_cast<CurrentContext>(dlsym(RTLD_DEFAULT, "OSMesaGetCurrentContext"));
    EXPECT_EQ(current && current(), name && std::string(name) == "osmesa");
    // This is the function that OSG calls: libGL's stub knows nothing of a context of OSMesa's.
    EXPECT_TRUE(glGetString(GL_RENDERER));
}

TEST_F(Context, IsOfTheVersionWhichTheEnvironmentNames)
{
    const char* version = std::getenv("MESA_GL_VERSION_OVERRIDE");
    const std::string found = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    EXPECT_EQ(found.rfind(version ? version : "4", 0), 0u) << found;
    view_->draw();
    const unsigned int id =
        view_->viewer().getCamera()->getGraphicsContext()->getState()->getContextID();
    const char* disabled = std::getenv("OSG_GL_EXTENSION_DISABLE");
    std::istringstream words(disabled ? disabled : "");
    for (std::string word; words >> word;)
        EXPECT_FALSE(osg::isGLExtensionSupported(id, word.c_str())) << word;
    EXPECT_TRUE(osg::isGLExtensionSupported(id, "GL_EXT_framebuffer_object"));
}

}  // namespace
}  // namespace fbrdf::test
