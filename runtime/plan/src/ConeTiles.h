// ConeTiles.h - the tiles of rows that a cone may be in, several rows at a time.
#pragma once
#include "ClusterSpans.h"

namespace fbrdf {

/// Shortens each row of `ends` to the tiles that are not certain to be outside of the cone. reach:
/// with a cone, and of coordinates whose squares floats have room for.
void trimToCone(const Tiles& tiles, const Reach& reach, RowEnds& ends);

}  // namespace fbrdf
