#include "SolverKernel.h"

#define FBRDF_FACTOR factorBaseline
#define FBRDF_SOLVE solveBaseline
#include "SolverKernel.inl"
