#include <fbrdf/io/MaterialFile.h>
