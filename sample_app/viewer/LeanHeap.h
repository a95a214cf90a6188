// LeanHeap.h - the memory of a window that is open for hours.
#pragma once

namespace fbrdf::viewer {

/// Lets the C library give large buffers back to the system as soon as they are freed, and share
/// its heaps among threads. Unless told, glibc keeps a heap for each thread that there ever was,
/// and puts buffers of up to 32 MB into them once one of that size has been freed: fits and
/// pictures that came and went leave holes that are never filled. To be called before threads
/// begin. Does nothing with other C libraries.
void keepHeapLean();

}  // namespace fbrdf::viewer
