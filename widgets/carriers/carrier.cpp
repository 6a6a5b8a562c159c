#include "widgets/carriers/carrier.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace halfspace {

const Carrier *carrierOf(std::string_view file) {
  for (const Carrier &carrier : carriers())
    if (carrier.isOf(file))
      return &carrier;
  return nullptr;
}

bool namesCarrier(const std::string &file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return std::any_of(carriers().begin(), carriers().end(),
                     [&](const Carrier &carrier) { return carrier.ending == ending; });
}

std::string withSession(std::string picture, std::string_view session) {
  const Carrier *carrier = carrierOf(picture);
  return carrier ? carrier->put(std::move(picture), session) : picture;
}

} // namespace halfspace
