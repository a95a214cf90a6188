#include "GlslArchive.h"

#include <OgreArchiveManager.h>
#include <OgreDataStream.h>
#include <OgreResourceGroupManager.h>
#include <OgreString.h>

#include <cstdint>
#include <cstring>

namespace ogreFbrdf {
namespace {

const char kLocation[] = "fbrdf";

Ogre::String group()
{
    return Ogre::ResourceGroupManager::INTERNAL_RESOURCE_GROUP_NAME;
}

}  // namespace

GlslArchive::GlslArchive(const Ogre::String& name, const Ogre::String& type, const GlslTexts& texts)
    : Ogre::Archive(name, type), texts_(texts)
{
    mReadOnly = true;
}

Ogre::DataStreamPtr GlslArchive::open(const Ogre::String& file, bool) const
{
    const auto found = texts_.find(file);
    if (found == texts_.end()) return {};
    const std::string& text = found->second;
    auto stream = std::make_shared<Ogre::MemoryDataStream>(file, text.size());
    std::memcpy(stream->getPtr(), text.data(), text.size());
    return stream;
}

Ogre::StringVectorPtr GlslArchive::list(bool recursive, bool dirs) const
{
    return find("*", recursive, dirs);
}

Ogre::FileInfoListPtr GlslArchive::listFileInfo(bool recursive, bool dirs) const
{
    return findFileInfo("*", recursive, dirs);
}

Ogre::StringVectorPtr GlslArchive::find(const Ogre::String& pattern, bool, bool dirs) const
{
    auto names = std::make_shared<Ogre::StringVector>();
    for (const auto& entry : texts_)
        if (!dirs && Ogre::StringUtil::match(entry.first, pattern)) names->push_back(entry.first);
    return names;
}

Ogre::FileInfoListPtr GlslArchive::findFileInfo(const Ogre::String& pattern, bool recursive,
                                                bool dirs) const
{
    auto files = std::make_shared<Ogre::FileInfoList>();
    for (const Ogre::String& name : *find(pattern, recursive, dirs)) {
        const size_t size = texts_.at(name).size();
        files->push_back({this, name, "", name, size, size});
    }
    return files;
}

// OGRE keeps the first factory of a type for good, also when the library that had it is gone. A
// type that tells the place in memory is that of whatever factory is there now.
GlslArchiveFactory::GlslArchiveFactory()
    : type_("FbrdfGlsl" + std::to_string(reinterpret_cast<uintptr_t>(this)))
{
}

GlslArchiveFactory::~GlslArchiveFactory() = default;

const Ogre::String& GlslArchiveFactory::getType() const
{
    return type_;
}

Ogre::Archive* GlslArchiveFactory::createInstance(const Ogre::String& name, bool)
{
    return new GlslArchive(name, type_, texts_);
}

Ogre::String GlslArchiveFactory::dependencyOf(const std::string& text)
{
    const auto known = names_.find(text);
    if (known != names_.end()) return known->second;
    const std::string name = "fbrdf_" + std::to_string(names_.size());
    names_.emplace(text, name);
    texts_.emplace(name + ".glsl", text);
    // OGRE lists the files of a location once, when it is added.
    takeAway();
    Ogre::ResourceGroupManager::getSingleton().addResourceLocation(kLocation, type_, group());
    isLocated_ = true;
    return name;
}

void GlslArchiveFactory::clear()
{
    takeAway();
    texts_.clear();
    names_.clear();
}

void GlslArchiveFactory::takeAway()
{
    if (!isLocated_) return;
    Ogre::ResourceGroupManager::getSingleton().removeResourceLocation(kLocation, group());
    Ogre::ArchiveManager::getSingleton().unload(kLocation);
    isLocated_ = false;
}

}  // namespace ogreFbrdf
