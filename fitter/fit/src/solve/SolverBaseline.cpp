#include "solve/SolverKernel.h"

#define FBRDF_FACTOR factorBaseline
#define FBRDF_SOLVE solveBaseline
#include "solve/SolverKernel.inl"
