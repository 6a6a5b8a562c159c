#include "lessons/reading/markdown_entity.h"

#include "lessons/text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace halfspace {
namespace {

struct Named {
  std::string_view name;
  std::string_view character;
};

constexpr std::array named{Named{"amp", "&"},   Named{"lt", "<"},     Named{"gt", ">"},
                           Named{"quot", "\""}, Named{"apos", "'"},   Named{"nbsp", "\u00A0"},
                           Named{"copy", "©"},  Named{"deg", "°"},    Named{"ndash", "–"},
                           Named{"mdash", "—"}, Named{"hellip", "…"}, Named{"minus", "−"},
                           Named{"times", "×"}, Named{"middot", "·"}, Named{"le", "≤"},
                           Named{"ge", "≥"},    Named{"ne", "≠"},     Named{"asymp", "≈"}};

/// Of `#8722` or `#x2212`, what stands behind the `#`.
std::string numbered(std::string_view digits) {
  const bool hexadecimal = digits.starts_with('x') || digits.starts_with('X');
  digits.remove_prefix(hexadecimal ? 1 : 0);
  unsigned code = 0;
  const auto read =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
  constexpr std::string_view replacement = "\uFFFD";
  const std::string character = read.ec == std::errc() ? utf8(code) : "";
  return character.empty() || code < ' ' || firstNoText(character) ? std::string(replacement) : character;
}

} // namespace

std::string characterOfEntity(std::string_view entity) {
  if (entity.size() < 3)
    return std::string(entity);
  const std::string_view name = entity.substr(1, entity.size() - 2);
  if (name.starts_with('#'))
    return numbered(name.substr(1));
  const auto found =
      std::find_if(named.begin(), named.end(), [name](const Named &each) { return each.name == name; });
  return std::string(found == named.end() ? entity : found->character);
}

} // namespace halfspace
