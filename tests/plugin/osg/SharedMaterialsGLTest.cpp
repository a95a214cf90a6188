// A material file is read once, whoever asks for it, as long as it does not change.
#include "FilesTest.h"

#include <osg/observer_ptr>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <set>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using SharedMaterials = FilesTest;

/// Counts how often a file is opened.
class OpenCounter {
public:
    explicit OpenCounter(const std::string& path) : queue_(inotify_init1(IN_NONBLOCK))
    {
        // Equal events that follow one another become one: each opening is followed by a closing.
        EXPECT_GE(inotify_add_watch(queue_, path.c_str(), IN_OPEN | IN_CLOSE), 0) << path;
    }
    ~OpenCounter() { close(queue_); }
    OpenCounter(const OpenCounter&) = delete;
    OpenCounter& operator=(const OpenCounter&) = delete;

    /// Openings since the last call.
    int count() const
    {
        alignas(inotify_event) std::array<char, 4096> bytes{};
        int opened = 0;
        for (ssize_t size; (size = read(queue_, bytes.data(), bytes.size())) > 0;)
            for (ssize_t at = 0; at < size;) {
                inotify_event event{};
                std::memcpy(&event, bytes.data() + at, sizeof event);
                opened += event.mask & IN_OPEN ? 1 : 0;
                at += static_cast<ssize_t>(sizeof event + event.len);
            }
        return opened;
    }

private:
    int queue_;
};

TEST_F(SharedMaterials, ANodeOpensItsFileAsOftenAsTheMaterialAlone)
{
    const OpenCounter counter(path("noise.fbrdf"));
    ASSERT_TRUE(osgFbrdf::readMaterialObject(path("noise.fbrdf")));
    const int alone = counter.count();
    EXPECT_GT(alone, 0);
    const auto node = osgDB::readRefNodeFile(path("noise.fbrdf"));
    EXPECT_TRUE(node);
    EXPECT_EQ(counter.count(), alone);
}

TEST_F(SharedMaterials, TheEffectsOfASceneShareTheirFile)
{
    const OpenCounter counter(path("noise.fbrdf"));
    ASSERT_TRUE(osgFbrdf::readMaterialObject(path("noise.fbrdf")));
    const int alone = counter.count();
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    for (int i = 0; i < 3; ++i) scene->addChild(this->scene());
    ASSERT_TRUE(osgDB::writeNodeFile(*scene, path("scene.osgt")));
    scene = nullptr;
    counter.count();
    const auto read = osgDB::readRefNodeFile(path("scene.osgt"));
    ASSERT_TRUE(read);
    EXPECT_EQ(counter.count(), alone);
    std::set<const osgFbrdf::MaterialObject*> materials;
    for (unsigned int i = 0; i < 3; ++i) {
        const osg::Group& part = *read->asGroup()->getChild(i)->asGroup();
        materials.insert(dynamic_cast<const FactorizedBrdf&>(*part.getChild(0)).getMaterial());
    }
    EXPECT_EQ(materials.size(), 1u);
    EXPECT_EQ(materials.count(nullptr), 0u);
}

TEST_F(SharedMaterials, AChangedFileIsAnotherMaterial)
{
    const auto first = osgFbrdf::readMaterialObject(path("noise.fbrdf"));
    ASSERT_TRUE(first);
    EXPECT_EQ(osgFbrdf::readMaterialObject(path("noise.fbrdf")), first);
    writeMaterial(testMaterials()[4], path("noise.fbrdf"));
    const auto second = osgFbrdf::readMaterialObject(path("noise.fbrdf"));
    ASSERT_TRUE(second);
    EXPECT_NE(second, first);
    EXPECT_EQ(second->material().form.name, testMaterials()[4].form.name);
}

TEST_F(SharedMaterials, GoWhenNobodyUsesThem)
{
    osg::ref_ptr<osgFbrdf::MaterialObject> material =
        osgFbrdf::readMaterialObject(path("noise.fbrdf"));
    const osg::observer_ptr<osgFbrdf::MaterialObject> observer(material);
    ASSERT_TRUE(observer.valid());
    material = nullptr;
    EXPECT_FALSE(observer.valid());
}

}  // namespace
}  // namespace fbrdf::test
