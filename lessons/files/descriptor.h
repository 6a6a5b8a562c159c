// Open files as the operating system knows them.
#pragma once

#include <fcntl.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace halfspace {

/// A file descriptor, closed at the end of its life.
class Descriptor {
public:
  Descriptor() = default;
  explicit Descriptor(int descriptor) : m_descriptor(descriptor) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor &&other) noexcept : m_descriptor(std::exchange(other.m_descriptor, none)) {}
  Descriptor &operator=(Descriptor &&other) noexcept {
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
  }

  [[nodiscard]] int get() const { return m_descriptor; }
  [[nodiscard]] bool isOpen() const { return m_descriptor != none; }
  /// 0, or the number of the error that only now came to light (a network's disk may be full).
  int close();

private:
  static constexpr int none = -1;
  int m_descriptor = none;
};

/// Writes all of a text, waiting where the descriptor does not. 0, or the number of the error.
[[nodiscard]] int writeAll(int descriptor, std::string_view text);

/// What came of reading.
struct ReadPart {
  std::size_t count = 0; ///< 0 without an error: the end
  int error = 0;
};

/// Reads what is there, at most so many bytes, waiting where the descriptor does not.
[[nodiscard]] ReadPart readSome(int descriptor, char *into, std::size_t most);

/// Waits until what was written is on the disk. 0 also where the file system knows no such thing.
[[nodiscard]] int syncToDisk(int descriptor);

/// Why a system call failed, to stand in a sentence: `there is no room left on the disk`.
[[nodiscard]] std::string reasonOf(int error);

/// The sentence for a file that cannot be opened for reading.
[[nodiscard]] std::string whyNotOpened(int error);

} // namespace halfspace
