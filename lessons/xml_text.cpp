#include "lessons/xml_text.h"

namespace halfspace {

std::string escapedForXml(std::string_view text) {
  std::string xml;
  for (const char c : text)
    switch (c) {
    case '&':
      xml += "&amp;";
      break;
    case '<':
      xml += "&lt;";
      break;
    case '>':
      xml += "&gt;";
      break;
    case '"':
      xml += "&quot;";
      break;
    default:
      xml += c;
    }
  return xml;
}

std::string xmlElement(const std::string &name, const std::string &content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

} // namespace halfspace
