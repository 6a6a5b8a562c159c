// Worked lines where they stand on the page.
#pragma once

#include "lessons/lesson/practice.h"
#include "widgets/numbers/scrub.h"
#include "widgets/picture/theme.h"
#include "widgets/working/working_numbers.h"

#include <QWidget>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace halfspace {

class BlankField;
class NumberField;
struct TraceableFormula;

/// A number of the scene that is typed where a formula shows it.
struct TypedCoordinate {
  CoordinateSource number;
  Rational value;
};

/// Lines of a working: [begin, end).
struct LineRange {
  std::size_t begin = 0;
  std::size_t end = static_cast<std::size_t>(-1); ///< at most the last line
};

/// Shows lines of a step's working as a textbook would: formulas, their numbers, a sentence. It is as tall as
/// they need. A click on a number asks for its trace; one that is a coordinate can be scrubbed, and typed
/// after a double click.
class WorkingBlock : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive the block.
  explicit WorkingBlock(const Typesetter &typesetter, QWidget *parent = nullptr);
  ~WorkingBlock() override;

  /// Shows some of a step's lines, some of them with a field for what is left out, and what is said about
  /// some.
  void setWorking(const Working &working, Fade fade = {}, std::map<std::string, LineRemark> remarks = {},
                  LineRange shown = {});
  /// Takes the fields away, with what was typed: it was about other lines. Followed by setWorking.
  void forgetAnswers();
  /// While lines are held each keeps the height that it has had: what is dragged moves nothing else.
  void setHeld(bool held);
  void setTheme(const Theme &theme);
  /// The colour of marked terms, asked for at every painting.
  void setInkOf(std::function<QColor(const QString &markId)> inkOf);
  /// The terms of these marks stand out.
  void setHighlighted(std::set<std::string> markIds);
  /// The number whose trace is shown, here or in another block, and the lines that it came from.
  void setTrace(std::optional<NumberPlace> number, std::set<std::string> lines);
  /// Lets go of the number that the keys have chosen.
  void endChoice();

  /// The number that is typed in its formula and not entered yet; nothing where none is, or it would be
  /// refused.
  [[nodiscard]] std::optional<TypedCoordinate> typed() const;
  /// Ends a scrub, and enters the number that is typed and not entered yet. Why it is refused; else empty.
  [[nodiscard]] QString enterTyped();
  /// Takes back what is typed and refused.
  void dropTyped() { closeNumberField(); }

  /// Gives the focus to the first field; false where there is none.
  bool focusField();
  /// What the keys do beyond the last line (way 1) and before the first (−1): whether they have gone on.
  void setGoOn(std::function<bool(int way)> goOn) { m_goOn = std::move(goOn); }
  /// The keys come from a block above (way 1) or below (−1), to the nearest line. False where there is none.
  bool comeIn(int way);

  /// The numbers that can be touched.
  [[nodiscard]] ShownNumbers shownNumbers() const { return {m_lines, m_placed}; }
  /// What is shown and where.
  [[nodiscard]] const PlacedWorking &placed() const { return m_placed; }
  /// The lines as LaTeX, one below the other.
  [[nodiscard]] QString latexOfAll() const;
  /// What a screen reader is told when it asks: the lines, one below the other; the number that the keys have
  /// chosen, if they have.
  [[nodiscard]] QString spoken() const;

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  /// As narrow as its formulas can be made.
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  /// The pointer is on a term of this mark, or (empty) on none.
  void markHovered(const QString &markId);
  /// The learner has filled in a line, as 10, 10/3, 2*sqrt(43)/3 …
  void answered(const QString &lineId, const QString &text);
  /// … or wants to see it.
  void showRequested(const QString &lineId);
  /// The learner wants to see where a number comes from …
  void traceRequested(const halfspace::NumberPlace &number);
  /// … and no longer.
  void traceDropped();
  /// The keys have come to this place: it is to be in view.
  void reached(const QRect &place);

  // A number in a formula that is a coordinate is changed, as the signals of NumberField say.
  /// What is typed in place of a number has changed, and is not entered yet.
  void typing();
  void coordinateTyped(const halfspace::CoordinateSource &number, const halfspace::Rational &value);
  void coordinateStepped(const halfspace::CoordinateSource &number, int steps);
  void scrubStarted(const halfspace::CoordinateSource &number);
  void scrubbed(int steps);
  void scrubEnded(bool keep);

protected:
  void paintEvent(QPaintEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void changeEvent(QEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void mouseReleaseEvent(QMouseEvent *event) override;
  void mouseDoubleClickEvent(QMouseEvent *event) override;
  void leaveEvent(QEvent *event) override;
  bool event(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void contextMenuEvent(QContextMenuEvent *event) override;

private:
  void showLines(const Working &working);
  void typesetLines();
  [[nodiscard]] Typesetter::Picture pictureOf(const math::Row &formula) const;
  void setPiece(TypesetLine &line, LinePiece piece, TraceableFormula formula) const;
  /// Takes what looks as it did before from before.
  [[nodiscard]] TypesetLine typeset(const WorkingLine &line) const;
  [[nodiscard]] TypesetLine typesetPartially(const WorkingLine &line) const;
  void placeLines();
  [[nodiscard]] PlacedWorking placeIn(int width) const;
  /// Keeps the heights that the lines have now.
  void hold();
  /// The lines that it shows.
  [[nodiscard]] std::vector<WorkingLine> ownLines() const;
  /// What is left out of the line; null when nothing is.
  [[nodiscard]] const Gap *gapOf(const std::string &lineId) const;
  /// Whether the line does not tell all that it says.
  [[nodiscard]] bool hides(const std::string &lineId) const;
  /// The room of a field, or of the blank where there is none.
  [[nodiscard]] math::Room roomOfGap(const std::string &lineId) const;
  [[nodiscard]] QString textOf(const WorkingLine &line) const;
  [[nodiscard]] QString latexOf(const WorkingLine &line) const;
  /// What is said about lines, by their ids.
  [[nodiscard]] std::map<std::string, QString> remarkTexts() const;
  /// Makes and removes fields; whether the one that had the focus is gone.
  bool matchFields();
  void followFocus(QWidget *focused);
  void bringIntoView(const std::string &lineId);
  void moveFields();
  void addField(const WorkingLine &line, const Gap &gap);
  static void dropField(BlankField &field);
  void tellSpoken();
  void hover(const QString &markId);
  void hoverNumber(std::optional<NumberPlace> number);
  void setCurrentLine(std::optional<std::size_t> line);
  /// The line is the current one, reached by the keys.
  void reach(const QRectF &box);
  // Whether the key had a meaning.
  bool stepByKey(int key);
  bool stepLine(int way);
  void copy(const QString &text) const;
  [[nodiscard]] std::optional<std::size_t> lineAt(QPointF position) const;
  [[nodiscard]] QString markAt(QPointF position) const;
  [[nodiscard]] QColor inkOf(const QString &markId) const;

  void connectScrub();
  void pressNumber(const NumberPlace &number, const QMouseEvent &event);
  /// Chooses the number beside the one that is chosen in the current line; false where it has none.
  bool chooseBeside(int way);
  bool useChosen();
  void openNumberField(const NumberPlace &number);
  void closeNumberField();
  void connectNumberField(NumberField &field, const CoordinateSource &number);
  void followNumberField();
  void moveNumberField();
  void showTip(const QPoint &at);
  [[nodiscard]] std::optional<LineRemark> remarkOf(const std::string &lineId) const;

  void paintBackground(QPainter &painter, std::size_t index) const;
  void paintNumbers(QPainter &painter, std::size_t index) const;
  void paintLine(QPainter &painter, std::size_t index) const;
  void paintHighlights(QPainter &painter, const PlacedFormula &formula) const;
  void paintRemark(QPainter &painter, const PlacedLine &line, const LineRemark &remark) const;

  const Typesetter &m_typesetter;
  Theme m_theme;
  std::function<QColor(const QString &)> m_inkOf;
  std::function<bool(int way)> m_goOn;
  std::set<std::string> m_highlighted;
  Working m_working; ///< of the step
  LineRange m_shown{0, 0};
  Fade m_fade;
  std::map<std::string, LineRemark> m_remarks;
  std::map<std::string, BlankField *> m_fields; ///< by the lines' ids
  std::vector<TypesetLine> m_lines;
  mutable SentenceBreaker m_sentences;
  PlacedWorking m_placed;
  std::optional<HeldLines> m_held; ///< as they stood last, while they are held
  QString m_hovered;
  std::optional<std::size_t> m_current; ///< the line that was clicked or reached by the keys

  std::optional<NumberPlace> m_hoveredNumber;
  std::optional<NumberPlace> m_pressedNumber; ///< until the button is up, or its scrub ends
  std::optional<NumberPlace> m_chosenNumber;  ///< by the keys
  std::optional<NumberPlace> m_tracedNumber;  ///< here or in another block
  std::set<std::string> m_tracedLines;
  Scrub m_scrub;
  /// A coordinate that is typed in its formula.
  struct TypedNumber {
    NumberPlace place;
    NumberField *field;
    QString refusal; ///< why the text is not taken; empty when it may be
  };
  std::optional<TypedNumber> m_typed;
};

} // namespace halfspace
