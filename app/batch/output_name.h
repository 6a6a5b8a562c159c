// Names of files that are filled in: figures/{lesson}-{step}.png.
#pragma once

#include "lessons/result.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// The places that every batch knows; others are columns of its rows.
inline constexpr std::string_view lessonPlace = "lesson";
inline constexpr std::string_view stepPlace = "step";
inline constexpr std::string_view rowPlace = "row";
inline constexpr std::string_view framePlace = "frame";

/// The name of a file with places for what it shows.
class OutputName {
public:
  /// Reads a name as it is typed. {step:02} has at least two digits. With `hasFrames`, %04d is {frame:04}.
  [[nodiscard]] static Result<OutputName> parse(const std::string &typed, bool hasFrames);

  [[nodiscard]] bool has(std::string_view place) const;
  /// What its places are called, in their order.
  [[nodiscard]] std::vector<std::string> places() const;

  using Filling = std::function<std::string(const std::string &place)>;
  /// The name with each place filled. What fills one stays within its folder: slashes and control characters
  /// become hyphens, and so does what is empty or has nothing but dots.
  [[nodiscard]] std::string filled(const Filling &filling) const;

  /// The folder before the first place, which somebody has made; empty for the present one.
  [[nodiscard]] std::string fixedFolder() const;

private:
  /// Text that stands for itself, and the place behind it.
  struct Part {
    std::string text;
    std::string place{}; ///< empty at the end
    std::size_t digits = 0;
  };
  [[nodiscard]] static Result<Part> placeOf(std::string_view inBraces);

  std::vector<Part> m_parts;
};

} // namespace halfspace
