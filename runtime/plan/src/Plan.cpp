#include <fbrdf/plan/Plan.h>
