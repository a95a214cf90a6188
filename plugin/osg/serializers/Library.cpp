// Names the wrapper classes, for programs that link the library statically.
#include <osgDB/Registry>

USE_SERIALIZER_WRAPPER(osgFbrdf_AreaLights)
USE_SERIALIZER_WRAPPER(osgFbrdf_ClassicNumbers)
USE_SERIALIZER_WRAPPER(osgFbrdf_EnvironmentLight)
USE_SERIALIZER_WRAPPER(osgFbrdf_FactorizedBrdf)
USE_SERIALIZER_WRAPPER(osgFbrdf_MaterialObject)
USE_SERIALIZER_WRAPPER(osgFbrdf_PointLights)

extern "C" void wrapper_serializer_library_osgFbrdf(void) {}
