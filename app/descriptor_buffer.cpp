#include "app/descriptor_buffer.h"

#include <ios>

namespace halfspace {

DescriptorBuffer::int_type DescriptorBuffer::underflow() {
  constexpr std::size_t bufferSize = 1U << 16U;
  m_read.resize(bufferSize);
  const ReadPart part = readSome(m_descriptor, m_read.data(), m_read.size());
  if (part.error != 0)
    throw std::ios_base::failure(reasonOf(part.error));
  setg(m_read.data(), m_read.data(), m_read.data() + part.count);
  return part.count == 0 ? traits_type::eof() : traits_type::to_int_type(*gptr());
}

std::streamsize DescriptorBuffer::xsputn(const char *text, std::streamsize count) {
  return writeAll(m_descriptor, {text, static_cast<std::size_t>(count)}) == 0 ? count : 0;
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof()))
    return traits_type::not_eof(character);
  const char c = traits_type::to_char_type(character);
  return xsputn(&c, 1) == 1 ? character : traits_type::eof();
}

} // namespace halfspace
