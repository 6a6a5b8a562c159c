// SVG: an element of its own among the metadata, deflated and as base64, so that no program that lays the
// file out anew changes it. It is found by the word that it begins with, whatever its element is called by
// then: no XML is read.
#include "lessons/words.h"
#include "widgets/carriers/base64.h"
#include "widgets/carriers/carrier.h"
#include "widgets/carriers/deflate.h"
#include "widgets/carriers/packed_scene.h"

namespace halfspace {
namespace {

/// Behind what may stand before it, a document says within so many bytes that it is an SVG.
constexpr std::size_t bytesOfBeginning = 4096;

bool isSvg(std::string_view file) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  std::string_view beginning = file.substr(0, bytesOfBeginning);
  if (beginning.starts_with(byteOrderMark))
    beginning.remove_prefix(byteOrderMark.size());
  const auto first = beginning.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && beginning[first] == '<' &&
         (beginning.find("<svg") != std::string_view::npos ||
          beginning.find("http://www.w3.org/2000/svg") != std::string_view::npos);
}

/// What the session's text begins with, in front of the base64.
std::string sign() {
  std::string sign(carriedName);
  sign.push_back(':'); // GCC 12 suspects `+` of reading beyond it
  return sign;
}

std::string putIntoSvg(std::string picture, std::string_view session) {
  const auto end = picture.rfind("</svg>");
  if (end == std::string::npos)
    return picture;
  return picture.insert(end, "<metadata><session xmlns=\"urn:halfspace:session\">" + sign() +
                                 base64(deflated(session)) + "</session></metadata>\n");
}

Result<std::string> takeFromSvg(std::string_view picture) {
  const auto begin = picture.find(sign());
  if (begin == std::string_view::npos)
    return noScene();
  const std::string_view text = picture.substr(begin + sign().size());
  const auto packed = fromBase64(text.substr(0, text.find('<')));
  return packed ? unpackedScene(*packed) : damagedScene();
}

} // namespace

Carrier svg_carrier() {
  return {
      "SVG",       ".svg",
      isSvg,       putIntoSvg,
      takeFromSvg, [] { return words("Programs that clean the file up or convert it may lose the scene."); }};
}

} // namespace halfspace
