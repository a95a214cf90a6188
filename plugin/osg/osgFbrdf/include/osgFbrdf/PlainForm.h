// PlainForm.h - scenes for programs without this library, which leave out nodes of its classes and
// everything below them ("Unsupported wrapper class").
//
// The plain form has an osg::Group where an effect was, with an osg::Material as bright as it, and
// osg::LightSources for the eight most intense of all PointLights and AreaLights; ambient light
// stands for an EnvironmentLight. What stood there is kept as text in a user value of the group, so
// that restored() gives the scene back. Files: osgdb_fbrdf writes
// the plain form to SCENE.EXT for the name SCENE.EXT.fbrdf, and restores it where that is read.
#pragma once
#include <osg/Node>
#include <osgDB/Options>

namespace osgFbrdf {

/// A copy of the scene in the plain form. Drawables and state sets that need no change are shared
/// with the scene.
osg::ref_ptr<osg::Node> plainForm(const osg::Node& scene);

/// The scene that a plain form was made of; other scenes stay as they are. The nodes are those of
/// the plain form. A group whose record cannot be read gives a warning and stays plain. options:
/// where to find materials.
osg::ref_ptr<osg::Node> restored(osg::Node& plain, const osgDB::Options* options = nullptr);

}  // namespace osgFbrdf
