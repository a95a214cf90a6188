// Expect.h - see support/ExpectError.h.
#pragma once
#include "support/ExpectError.h"
