#include "LogLine.h"

#include <OgreLogManager.h>

namespace ogreFbrdf {

void warn(const std::string& where, const std::string& problem)
{
    Ogre::LogManager::getSingleton().logWarning("ogreFbrdf: " + where + ": " + problem);
}

}  // namespace ogreFbrdf
