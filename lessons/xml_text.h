// Text among the tags of XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// The text as it stands between tags, or in an attribute in double quotes.
[[nodiscard]] std::string escapedForXml(std::string_view text);

/// An element without attributes. `content` is XML already.
[[nodiscard]] std::string xmlElement(const std::string &name, const std::string &content);

} // namespace halfspace
