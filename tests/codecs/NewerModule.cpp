// NewerModule.cpp - a module of an interface that does not exist yet.
#include "PictureModule.h"

extern "C" const fbrdf_picture_module* fbrdf_open_picture_module()
{
    static constexpr fbrdf_picture_module module = {1000, nullptr, nullptr, nullptr, nullptr};
    return &module;
}
