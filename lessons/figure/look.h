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

/// How the lines of an object are drawn.
enum class LineStyle : std::uint8_t { Solid, Dashed, Dotted };
inline constexpr std::size_t lineStyleCount = 3;

/// What labels say: the letter of what they stand beside, or that and its numbers.
enum class LabelText : std::uint8_t { Name, Value };
inline constexpr std::size_t labelTextCount = 2;

struct Look {
  std::optional<Hue> hue{};        ///< nothing: each mark has the hue of its subject
  std::optional<LineStyle> line{}; ///< nothing: its rank decides
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

/// The same of styles of lines, and of what labels say.
[[nodiscard]] std::string_view nameOf(LineStyle style);
[[nodiscard]] std::optional<LineStyle> findLineStyle(std::string_view name);
[[nodiscard]] std::vector<std::string> lineStyleNames();
[[nodiscard]] std::string_view nameOf(LabelText text);
[[nodiscard]] std::optional<LabelText> findLabelText(std::string_view name);
[[nodiscard]] std::vector<std::string> labelTextNames();

} // namespace halfspace
