// The lines of a block where they stand.
#pragma once

#include "widgets/working/working_numbers.h"

#include <optional>

namespace halfspace {

/// What is said about lines, by their ids.
using LineRemarks = std::map<std::string, LineRemark>;

/// Places typeset lines in the width of their block, and tells what stands at a place of it. While lines are
/// held each keeps the height that it has had.
class BlockLayout {
public:
  void setLines(std::vector<TypesetLine> lines) { m_lines = std::move(lines); }
  /// Nothing stands anywhere.
  void clear();
  void setRemarks(LineRemarks remarks);
  void setHeld(bool held);
  [[nodiscard]] bool isHeld() const { return m_held.has_value(); }
  /// Held lines are free once: in another width, or in other type, they have other heights.
  void forgetHeights();

  /// Gives the lines their places, in pixels.
  void place(const QFont &font, double width);
  /// How high the lines are where nothing stands yet.
  [[nodiscard]] double heightIn(const QFont &font, double width) const;

  [[nodiscard]] const std::vector<TypesetLine> &lines() const { return m_lines; }
  [[nodiscard]] const PlacedWorking &placed() const { return m_placed; }
  /// The numbers that can be touched.
  [[nodiscard]] ShownNumbers numbers() const { return {m_lines, m_placed}; }
  /// What is said about a line; null where nothing is.
  [[nodiscard]] const LineRemark *remarkOf(std::size_t line) const;
  /// The room of a line, in whole pixels. Requires one that is placed.
  [[nodiscard]] QRect roomOf(std::size_t line) const { return m_placed.lines.at(line).box.toAlignedRect(); }

  [[nodiscard]] std::optional<std::size_t> lineAt(QPointF position) const;
  /// The id of the innermost mark at a place; empty for none.
  [[nodiscard]] QString markAt(QPointF position) const;

private:
  void hold();

  std::vector<TypesetLine> m_lines;
  LineRemarks m_remarks;
  std::map<std::string, QString> m_remarkTexts;
  mutable SentenceBreaker m_sentences; ///< it remembers what it broke
  PlacedWorking m_placed;
  std::optional<HeldLines> m_held; ///< as they stood last, while they are held
};

} // namespace halfspace
