#include "widgets/carriers/carrier.h"

#include "widgets/carriers/qr/photograph.h"

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

const Carrier *carrierWith(const std::string &ending) {
  for (const Carrier &carrier : carriers())
    if (carrier.ending == ending)
      return &carrier;
  return nullptr;
}

std::vector<std::string> pictureEndings() {
  std::vector<std::string> endings;
  for (const Carrier &carrier : carriers())
    endings.push_back(carrier.ending);
  endings.insert(endings.end(), photographEndings.begin(), photographEndings.end());
  return endings;
}

bool namesPicture(const std::string &file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  const std::vector<std::string> endings = pictureEndings();
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::string withSession(std::string picture, std::string_view session) {
  const Carrier *carrier = carrierOf(picture);
  return carrier ? carrier->put(std::move(picture), session) : picture;
}

} // namespace halfspace
