#include "app/memory.h"

#include <cstdlib> // tells which C library it is

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace halfspace {

#ifdef __GLIBC__

namespace {

/// Bytes from which on a buffer is large: a label is smaller, a picture or a buffer of the window is not.
constexpr int largeBuffer = 256 * 1024;

} // namespace

void returnLargeBuffers() { mallopt(M_MMAP_THRESHOLD, largeBuffer); }

void returnFreeMemory() { malloc_trim(0); }

#else

void returnLargeBuffers() {}

void returnFreeMemory() {}

#endif

} // namespace halfspace
