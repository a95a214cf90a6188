#include <fbrdf/gl/Renderer.h>
