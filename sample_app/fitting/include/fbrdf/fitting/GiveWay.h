// GiveWay.h - threads that work while somebody looks at a window.
#pragma once

namespace fbrdf::fitting {

/// Lets what draws go first: the thread that calls it, and all that it starts afterwards, get the
/// processor where others leave it, and a third of their share where they do not. Linux alone has a
/// priority of threads that anybody may lower; elsewhere nothing happens.
void giveWay();

}  // namespace fbrdf::fitting
