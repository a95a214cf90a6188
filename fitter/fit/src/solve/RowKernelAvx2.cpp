#include "solve/RowKernel.h"

#define FBRDF_ROW_KERNELS kRowKernelsAvx2
#include "solve/RowKernel.inl"
