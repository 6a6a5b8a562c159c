// What the program does so that memory which it no longer needs goes back to the system.
#pragma once

namespace halfspace {

/// From now on large buffers go back as soon as they are freed. glibc otherwise takes the first one that is
/// freed as a sign to keep the next ones, up to 32 MB each, in the heap of the thread that asks for them:
/// every size of the window and every picture then leaves its holes. For a program that shows a window;
/// before its first buffer. Elsewhere than with glibc it does nothing.
void returnLargeBuffers();

/// Gives back what is free in the heaps of all threads. For the end of something rare and large.
void returnFreeMemory();

} // namespace halfspace
