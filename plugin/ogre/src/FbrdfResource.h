// FbrdfResource.h - a .fbrdf as a resource of OGRE, which all passes with it share.
#pragma once
#include "TableTexture.h"

#include <fbrdf/brdf/Material.h>

#include <OgreResource.h>

#include <set>
#include <string>
#include <vector>

namespace ogreFbrdf {

/// A material of OGRE whose shaders are made of a resource; it is made anew when that changes.
struct MaterialUser {
    Ogre::String scheme, material, group;
    bool operator<(const MaterialUser& other) const;
};

/// Loading does not fail: what is wrong with the file is problem(). A resource that was good before
/// stays as it was, and the log says so.
class FbrdfResource : public Ogre::Resource {
public:
    FbrdfResource(Ogre::ResourceManager* manager, const Ogre::String& name,
                  Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                  Ogre::ManualResourceLoader* loader);
    ~FbrdfResource() override;

    bool isGood() const { return !tables_.empty(); }
    /// Why there is no material, "" where there is one.
    const std::string& problem() const { return problem_; }
    const fbrdf::Material& material() const { return material_; }
    const std::vector<TableTexture>& tables() const { return tables_; }
    /// What a diffuse fallback reflects; grey where there is no material.
    const fbrdf::Vec3f& albedo() const { return albedo_; }
    void addUser(const MaterialUser& user) { users_.insert(user); }

private:
    void loadImpl() override;
    void unloadImpl() override;
    size_t calculateSize() const override;
    void read();
    void makeTables();

    fbrdf::Material material_;
    std::string problem_;
    fbrdf::Vec3f albedo_{0.5f};
    std::vector<TableTexture> tables_;
    std::set<MaterialUser> users_;
    bool hasMaterial_ = false;
};
using FbrdfResourcePtr = std::shared_ptr<FbrdfResource>;

}  // namespace ogreFbrdf
