// FileBytes.h - see support/FileBytes.h.
#pragma once
#include "support/FileBytes.h"
