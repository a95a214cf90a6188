// PartNames.h - which part of a model a node is in, by the names in a table of parts.
#pragma once
#include <osg/Node>

#include <string>
#include <unordered_map>
#include <vector>

namespace osgFbrdf {

class FactorizedBrdf;
struct ModelPart;

/// True where the effect draws what is in no part, which else keeps its own state.
bool drawsRest(const FactorizedBrdf& effect);

/// No part of the table.
constexpr int kRest = -1;

/// The part that a node is in.
struct PartPlace {
    int part = kRest;            ///< index into the table
    bool byOsgMaterial = false;  ///< the name of an osg::Material decided
    int beside = kRest;          ///< if so: the part that other osg::Materials are in
};

class PartNames {
public:
    explicit PartNames(const std::vector<ModelPart>& parts);

    /// The part that the node and what is below it are in, where its parent is in `above`: the name
    /// of its osg::Material decides, then that of its state set, then its own. An osg::Material
    /// that the table does not have ends a part that another began.
    PartPlace inside(const osg::Node& node, const PartPlace& above) const;

    /// The names that nothing below the model has, as far as it is loaded.
    std::vector<std::string> namesWithoutPart(osg::Group& model) const;

private:
    int find(const std::string& name) const;

    std::unordered_map<std::string, int> indices_;
};

}  // namespace osgFbrdf
