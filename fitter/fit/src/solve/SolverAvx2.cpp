#include "solve/SolverKernel.h"

#define Eigen FbrdfEigenAvx2
#define FBRDF_FACTOR factorAvx2
#define FBRDF_SOLVE solveAvx2
#include "solve/SolverKernel.inl"
