// The look of an object: what tells it from others of its kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// The colours of the palette. How each is mixed is for the themes to say.
enum class Hue : std::uint8_t { Grey, Blue, Orange, Yellow, Green, Purple, Pink, Red };
inline constexpr std::size_t hueCount = 8;

struct Look {
  std::optional<Hue> hue{}; ///< nothing: each mark has the hue of its subject
  /// How many objects above are about the same subject: each draws its lines in another rhythm, so that they
  /// are told apart without colours, too.
  std::size_t rank = 0;
  bool operator==(const Look &) const = default;
};

/// Its name in files.
[[nodiscard]] std::string_view nameOf(Hue hue);
/// The hue of this name; nothing where there is none.
[[nodiscard]] std::optional<Hue> findHue(std::string_view name);
/// The names of all hues.
[[nodiscard]] std::vector<std::string> hueNames();

} // namespace halfspace
