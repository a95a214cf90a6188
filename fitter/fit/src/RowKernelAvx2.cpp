#include "RowKernel.h"

#define FBRDF_ROW_KERNELS kRowKernelsAvx2
#include "RowKernel.inl"
