// SeamlessCubes.h - filters cube maps across the edges of their faces where a context can. As a
// mode of a state set it would be an error of OpenGL in contexts that do not know it.
#pragma once
#include <osg/StateAttribute>

namespace osgFbrdf {

class SeamlessCubes : public osg::StateAttribute {
public:
    SeamlessCubes() = default;  ///< as the host has it: what OSG applies after one that is on
    explicit SeamlessCubes(bool on) : on_(on) {}
    SeamlessCubes(const SeamlessCubes& other, const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY)
        : osg::StateAttribute(other, op), on_(other.on_)
    {
    }
    META_StateAttribute(osgFbrdf, SeamlessCubes, VALIDATOR)

    /// Types are OSG's; among those of validators this number is ours.
    unsigned int getMember() const override { return 0xfb2d; }
    int compare(const osg::StateAttribute& other) const override;
    void apply(osg::State& state) const override;

protected:
    ~SeamlessCubes() override = default;

private:
    bool on_ = false;
};

}  // namespace osgFbrdf
