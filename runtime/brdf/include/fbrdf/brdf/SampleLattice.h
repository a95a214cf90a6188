// SampleLattice.h - points that cover the unit square evenly, the same ones each time: a lattice of
// rank 1. Along x there is one point in each interval, and neighbours along x are far apart along
// y.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <cmath>

namespace fbrdf {

/// By how many intervals y turns from one point to the next: about count over the golden ratio, and
/// without a divisor in common with count, so that no two points have the same y. count >= 1.
int latticeStep(int count);

/// Point `index` of 0 to count - 1, each coordinate in (0, 1). Twin: fbrdfSamplePoint.
template <class T>
Vec2<T> samplePoint(T index, const Vec2<T>& lattice)
{
    const T turned = index * lattice.y;
    return {(index + T(0.5)) / lattice.x,
            (turned - lattice.x * std::floor(turned / lattice.x) + T(0.5)) / lattice.x};
}

}  // namespace fbrdf
