// QR codes found in pictures.
#pragma once

#include "widgets/carriers/qr/grey_image.h"

#include <string>
#include <vector>

namespace halfspace {

struct ReadCode {
  std::string text;     ///< its bytes
  bool isWhole = false; ///< false: more of it is unreadable than it can make up for
  bool operator==(const ReadCode &) const = default;
};

/// The codes in a picture, wherever they stand and however they are turned; those that say the same once.
/// Where none is whole, those that are not, of which ZXing tells from 2.0 on. In pictures that look like
/// hundreds of corners of codes this takes minutes.
[[nodiscard]] std::vector<ReadCode> readCodes(const GreyImage &image);

} // namespace halfspace
