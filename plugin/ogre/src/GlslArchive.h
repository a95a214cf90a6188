// GlslArchive.h - the texts of materials as files that OGRE's shader generator includes, in memory.
#pragma once
#include <OgreArchive.h>
#include <OgreArchiveFactory.h>

#include <map>
#include <set>
#include <string>

namespace ogreFbrdf {

/// Texts that a GlslArchive opens, by file name.
using GlslTexts = std::map<std::string, std::string>;

/// An archive over texts that somebody else owns.
class GlslArchive : public Ogre::Archive {
public:
    GlslArchive(const Ogre::String& name, const Ogre::String& type, const GlslTexts& texts);
    bool isCaseSensitive() const override { return true; }
    void load() override {}
    void unload() override {}
    Ogre::DataStreamPtr open(const Ogre::String& file, bool readOnly) const override;
    Ogre::StringVectorPtr list(bool recursive, bool dirs) const override;
    Ogre::FileInfoListPtr listFileInfo(bool recursive, bool dirs) const override;
    Ogre::StringVectorPtr find(const Ogre::String& pattern, bool recursive,
                               bool dirs) const override;
    bool exists(const Ogre::String& file) const override { return texts_.count(file) > 0; }
    time_t getModifiedTime(const Ogre::String&) const override { return 0; }
    Ogre::FileInfoListPtr findFileInfo(const Ogre::String& pattern, bool recursive,
                                       bool dirs) const override;

private:
    const GlslTexts& texts_;
};

/// The resource location that has the texts. It is there from the first text on.
class GlslArchiveFactory : public Ogre::ArchiveFactory {
public:
    GlslArchiveFactory();
    GlslArchiveFactory(const GlslArchiveFactory&) = delete;
    GlslArchiveFactory& operator=(const GlslArchiveFactory&) = delete;
    ~GlslArchiveFactory() override;
    const Ogre::String& getType() const override;
    using Ogre::ArchiveFactory::createInstance;
    Ogre::Archive* createInstance(const Ogre::String& name, bool readOnly) override;
    void destroyInstance(Ogre::Archive* archive) override { delete archive; }

    /// Makes a text known, and returns the name by which a program depends on it. Equal texts have
    /// one name, so that materials that differ in their texels alone share programs.
    Ogre::String dependencyOf(const std::string& text);
    /// Forgets all texts and takes the location away from OGRE's resources.
    void clear();

private:
    void takeAway();

    const Ogre::String type_;
    GlslTexts texts_;
    std::map<std::string, std::string> names_;  ///< by text
    bool isLocated_ = false;
};

}  // namespace ogreFbrdf
