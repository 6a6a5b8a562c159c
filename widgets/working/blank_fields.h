// The fields in the blank lines of a block.
#pragma once

#include "widgets/formula/math_tree.h"
#include "widgets/working/block_layout.h"
#include "widgets/working/shown_lines.h"

#include <QWidget>

namespace halfspace {

class BlankField;

/// Has a field for each line that leaves something to the learner, in the room that the line keeps for it.
class BlankFields : public QObject {
  Q_OBJECT
public:
  /// The fields are children of the block. Both must outlive it.
  BlankFields(QWidget &block, const BlockLayout &layout);

  /// Makes the fields that these lines ask for, with what is said of their answers, and takes away all
  /// others; whether the one that had the focus is gone.
  bool match(const ShownLines &lines, const LineRemarks &remarks);
  /// Takes the fields away, with what was typed: it was about other lines. Followed by match.
  void forget();
  /// Puts the fields where their lines leave room.
  void place();

  [[nodiscard]] bool isEmpty() const { return m_fields.empty(); }
  /// The room that the field of a line needs in its formula. Requires that it has one.
  [[nodiscard]] math::Room roomFor(const std::string &lineId) const;
  /// Gives the focus to the first field; false where there is none.
  bool focusFirst();
  /// Gives the focus to the field of a line, if it has one.
  void focusIn(std::size_t line);
  /// Tells which line's field has the focus, if one has.
  void followFocus(const QWidget *focused);

signals:
  /// The learner has filled in a line, as 10, 10/3, 2*sqrt(43)/3 …
  void answered(const QString &lineId, const QString &text);
  /// … or wants to see it.
  void showRequested(const QString &lineId);
  void entered(std::size_t line); ///< its field has got the focus
  /// What is said of an answer is to be in view, with its line.
  void reached(const QRect &place);

private:
  [[nodiscard]] BlankField *fieldOf(const std::string &lineId) const;
  void add(const WorkingLine &line, const Gap &gap);
  void bringIntoView(const std::string &lineId);

  QWidget &m_block;
  const BlockLayout &m_layout;
  std::map<std::string, BlankField *> m_fields; ///< by the lines' ids
};

} // namespace halfspace
