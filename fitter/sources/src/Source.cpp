#include <fbrdf/sources/Source.h>
