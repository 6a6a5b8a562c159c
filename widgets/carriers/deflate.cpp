#include "widgets/carriers/deflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace halfspace {
namespace {

/// So much is unpacked at a time.
constexpr std::size_t partSize = 1U << 16U;

/// zlib counts in these; whoever hands over more gets what they unpack to.
constexpr std::size_t mostPacked = std::numeric_limits<uInt>::max();

} // namespace

std::string deflated(std::string_view content) {
  std::string packed(compressBound(content.size()), '\0');
  auto length = static_cast<uLongf>(packed.size());
  // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): zlib's bytes are unsigned.
  const int result =
      compress2(reinterpret_cast<Bytef *>(packed.data()), &length,
                reinterpret_cast<const Bytef *>(content.data()), content.size(), Z_BEST_COMPRESSION);
  // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
  packed.resize(result == Z_OK ? length : 0);
  return packed;
}

Inflated inflated(std::string_view packed, std::size_t mostBytes) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK)
    return {};
  // NOLINTBEGIN(cppcoreguidelines-pro-type-const-cast,cppcoreguidelines-pro-type-reinterpret-cast): zlib's
  // bytes are unsigned, and it does not say that it leaves those that it reads alone.
  stream.next_in = const_cast<Bytef *>(reinterpret_cast<const Bytef *>(packed.data()));
  stream.avail_in = static_cast<uInt>(std::min(packed.size(), mostPacked));
  Inflated inflated;
  int result = Z_OK;
  while (result == Z_OK && inflated.content.size() <= mostBytes) {
    const std::size_t begun = inflated.content.size();
    // One byte beyond the limit tells that there is more.
    const std::size_t room = std::min(partSize, mostBytes - begun + 1);
    inflated.content.resize(begun + room);
    stream.next_out = reinterpret_cast<Bytef *>(inflated.content.data() + begun);
    stream.avail_out = static_cast<uInt>(room);
    result = inflate(&stream, Z_NO_FLUSH);
    inflated.content.resize(begun + room - stream.avail_out);
  }
  // NOLINTEND(cppcoreguidelines-pro-type-const-cast,cppcoreguidelines-pro-type-reinterpret-cast)
  inflateEnd(&stream);
  inflated.isWhole = result == Z_STREAM_END && inflated.content.size() <= mostBytes;
  return inflated;
}

} // namespace halfspace
