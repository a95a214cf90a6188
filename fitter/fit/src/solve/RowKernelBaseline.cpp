#include "solve/RowKernel.h"

#define FBRDF_ROW_KERNELS kRowKernelsBaseline
#include "solve/RowKernel.inl"

namespace fbrdf {

RowKernels rowKernels()
{
#ifdef FBRDF_HAVE_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return kRowKernelsAvx2;
#endif
    return kRowKernelsBaseline;
}

}  // namespace fbrdf
