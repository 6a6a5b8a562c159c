// The worked lines of a step, in the blocks that they stand in.
#pragma once

#include "lessons/scene/provenance.h"
#include "widgets/working/step_coordinates.h"

namespace halfspace {

/// Gives each block its lines and speaks for all of them: what goes on in one is seen in the others.
class StepWorking : public QObject {
  Q_OBJECT
public:
  /// The typesetter must outlive it.
  explicit StepWorking(const Typesetter &typesetter, QObject *parent = nullptr);

  /// A block for the lines behind those of the block before; it belongs to the caller, and shows nothing
  /// until the next setWorking.
  [[nodiscard]] WorkingBlock *addBlock();
  /// The blocks so far hear nothing more, and are heard no more.
  void dropBlocks();
  [[nodiscard]] const std::vector<WorkingBlock *> &blocks() const { return m_blocks; }

  /// Shows a step's lines, so many in each block, some of them with a field for what is left out, and what is
  /// said about some.
  void setWorking(const Working &working, const std::vector<std::size_t> &linesIn, const Fade &fade = {},
                  const LineRemarks &remarks = {});
  /// The working with all its lines, of which only some may be shown: numbers are followed through it. It is
  /// asked for when they are; without it they are followed through the lines that are shown.
  void setWholeWorking(std::function<Working()> working) { m_wholeWorking = std::move(working); }

  /// The lines that stand on the page, in all blocks but those that are hidden with what is around them. They
  /// last until the next setWorking.
  [[nodiscard]] std::vector<ToldLine> toldLines() const;

  void setTheme(const Theme &theme);
  /// The colour of marked terms, asked for at every painting.
  void setInkOf(std::function<QColor(const QString &markId)> inkOf);
  /// The terms of these marks stand out.
  void setHighlighted(const std::set<std::string> &markIds);
  /// See WorkingBlock.
  void setHeld(bool held);
  /// Takes the fields of all blocks away, with what was typed. Followed by setWorking.
  void forgetAnswers();

  void trace(const NumberPlace &number);
  /// Lets go of the number that was traced, and of those that the keys have chosen.
  void endTrace();
  /// What the traced number came from; empty when there is none, or it is not shown.
  [[nodiscard]] const Provenance &traced() const { return m_traced; }

  /// Coordinates that are scrubbed and typed in the blocks.
  [[nodiscard]] StepCoordinates &coordinates() { return m_coordinates; }
  /// Gives the focus to the first field, or to a block where there is none.
  void focusField();

signals:
  void markHovered(const QString &markId);
  void answered(const QString &lineId, const QString &text);
  void showRequested(const QString &lineId);
  /// Another number is traced, or it came from something else; see traced().
  void traceChanged();
  /// What the keys have come to in a block.
  void reached(halfspace::WorkingBlock *block, const QRect &place);

private:
  /// Shows all blocks how their lines look now.
  void showLook();
  /// Whether a field of a block has the focus.
  [[nodiscard]] bool isTyping() const;
  /// The keys leave a block for the next one with lines, downwards or upwards; false where there is none.
  bool goOn(const WorkingBlock &from, int way);
  /// What depends on where the numbers stand and what they are.
  void followTrace();
  [[nodiscard]] const Term *tracedTerm() const;

  const Typesetter &m_typesetter;
  std::vector<WorkingBlock *> m_blocks;
  StepCoordinates m_coordinates{m_blocks};
  WorkingLook m_look;
  QString m_hovered; ///< the mark of a term in a block that the pointer is on; empty: none
  Working m_working;
  std::function<Working()> m_wholeWorking;
  std::optional<NumberPlace> m_tracedNumber;
  Provenance m_traced;
  bool m_held = false;
};

} // namespace halfspace
