// An open file of the operating system as the buffer of a C++ stream.
#pragma once

#include "lessons/files/descriptor.h"

#include <streambuf>
#include <vector>

namespace halfspace {

/// Reads and writes all that there is, also where the file was opened not to wait (a pipe that another
/// program has set so): then it waits by itself. A failure to read is thrown as std::ios_base::failure, as
/// the library's own file buffers do; a failure to write makes the stream bad. What is written goes out at
/// once.
class DescriptorBuffer : public std::streambuf {
public:
  /// The descriptor stays the caller's.
  explicit DescriptorBuffer(int descriptor) : m_descriptor(descriptor) {}

protected:
  int_type underflow() override;
  std::streamsize xsputn(const char *text, std::streamsize count) override;
  int_type overflow(int_type character) override;

private:
  int m_descriptor;
  std::vector<char> m_read;
};

} // namespace halfspace
