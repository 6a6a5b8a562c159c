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
  constexpr std::size_t pageBytes = std::size_t{2} << 20U;
  const std::size_t bytes = count * sizeof(T);
  const std::size_t toFirstPage =
      (pageBytes - reinterpret_cast<std::uintptr_t>(vector.data()) % pageBytes) % pageBytes;
  if (bytes >= toFirstPage + pageBytes) // advice alone: nothing is lost where it is not taken
    ::madvise(reinterpret_cast<std::byte *>(vector.data()) + toFirstPage,
              (bytes - toFirstPage) / pageBytes * pageBytes, MADV_HUGEPAGE);
#endif
}

} // namespace halfspace
