// Characters that Markdown names instead of writing them.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// The character of an entity in Markdown as `&lt;`, `&#8722;` or `&#x2212;`. Only names of characters that
/// people cannot write otherwise, or not easily, are known; an unknown entity stands as it is.
/// � for numbers of no character, or of a control character.
[[nodiscard]] std::string characterOfEntity(std::string_view entity);

} // namespace halfspace
