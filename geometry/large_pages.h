// Room for very many elements, of which the system is told beforehand.
#pragma once

#include <cstddef>
#include <vector>

#ifdef __linux__
#include <cstdint>
#include <sys/mman.h>
#endif

namespace halfspace {

/// Reserves room in an empty vector. Where the system has large pages it gives these: one fault for each
/// instead of hundreds, which is much of the time that it takes to fill a large vector.
template <class T> void reserveInLargePages(std::vector<T> &vector, std::size_t count) {
  vector.reserve(count);
#ifdef __linux__
  constexpr std::uintptr_t pageBytes = std::uintptr_t{2} << 20U;
  const auto begin = reinterpret_cast<std::uintptr_t>(vector.data());
  const std::uintptr_t end = begin + count * sizeof(T);
  const std::uintptr_t first = (begin + pageBytes - 1) / pageBytes * pageBytes;
  if (end >= first + pageBytes) // advice alone: nothing is lost where it is not taken
    ::madvise(reinterpret_cast<void *>(first), (end - first) / pageBytes * pageBytes, MADV_HUGEPAGE);
#endif
}

} // namespace halfspace
