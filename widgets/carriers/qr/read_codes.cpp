#include "widgets/carriers/qr/read_codes.h"

#include <ZXing/ReadBarcode.h>

#include <algorithm>

namespace halfspace {
namespace {

#if __has_include(<ZXing/ReaderOptions.h>)
using Options = ZXing::ReaderOptions;
#else // before 2.2
using Options = ZXing::DecodeHints;
#endif

/// In pictures of no more pixels than this, codes whose modules are only two or three pixels wide are looked
/// for as well. In larger ones that would take long, and codes are larger there too.
constexpr int mostPixelsDoubled = 1 << 22;

/// Whether codes are told of that are not whole. Where they are, others may not be found.
enum class Wanted { WholeCodes, AllCodes };

std::vector<ReadCode> codesIn(const GreyImage &image, Wanted wanted) {
  const ZXing::ImageView view(image.pixels.data(), image.width, image.height, ZXing::ImageFormat::Lum);
  Options options;
  options.setFormats(ZXing::BarcodeFormat::QRCode).setReturnErrors(wanted == Wanted::AllCodes);
  std::vector<ReadCode> codes;
  for (const auto &found : ZXing::ReadBarcodes(view, options)) {
    const auto &bytes = found.bytes();
    ReadCode code{{bytes.begin(), bytes.end()}, found.isValid()};
    if (std::find(codes.begin(), codes.end(), code) == codes.end())
      codes.push_back(std::move(code));
  }
  return codes;
}

} // namespace

std::vector<ReadCode> readCodes(const GreyImage &image) {
  std::vector<ReadCode> codes = codesIn(image, Wanted::WholeCodes);
  if (codes.empty() && image.height <= mostPixelsDoubled / image.width)
    codes = codesIn(doubled(image), Wanted::WholeCodes);
  return codes.empty() ? codesIn(image, Wanted::AllCodes) : codes;
}

} // namespace halfspace
