// Whatever the bytes: an image, and the codes in it, or a problem with a sentence; the same of what a code
// says.
#include "widgets/carriers/qr/qr_text.h"
#include "widgets/carriers/qr/read_codes.h"

#include <cstdint>
#include <cstdlib>

namespace {

using namespace halfspace;

/// Larger images take longer to be searched than there is time for each of very many.
constexpr std::size_t mostPixelsSearched = 1U << 20U;

void requireSentence(const Problem &problem) {
  if (problem.sentence.empty())
    std::abort();
}

void read(std::string_view text) {
  const auto session = sessionInQrText(text);
  if (!session)
    requireSentence(session.problem());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char *>(data), size);
  if (!isPixelPicture(bytes)) {
    read(bytes);
    return 0;
  }
  const auto image = greyImageOf(bytes);
  if (!image) {
    requireSentence(image.problem());
    return 0;
  }
  if (image->pixels.size() <= mostPixelsSearched)
    for (const ReadCode &code : readCodes(*image))
      read(code.text);
  return 0;
}
