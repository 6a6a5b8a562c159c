// The worked lines beside the picture.
#pragma once

#include "lessons/lesson/practice.h"
#include "lessons/scene/provenance.h"
#include "widgets/numbers/scrub.h"
#include "widgets/picture/theme.h"
#include "widgets/working/working_numbers.h"

#include <QAbstractScrollArea>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace halfspace {

class BlankField;
class NumberField;
struct TraceableFormula;

/// Shows a working as a textbook would: formulas, their numbers, a sentence. A click on a number lights up
/// the lines and terms that it came from; one that is a coordinate can be scrubbed, and typed after a double
/// click.
class WorkingPanel : public QAbstractScrollArea {
  Q_OBJECT
public:
  /// The typesetter must outlive the panel.
  explicit WorkingPanel(const Typesetter &typesetter, QWidget *parent = nullptr);
  ~WorkingPanel() override;

  /// Shows the lines, some of them with a field for what is left out, and what is said about some.
  void setWorking(const Working &working, Fade fade = {}, std::map<std::string, LineRemark> remarks = {});
  /// Shows the lines with a blank instead of numbers and result, to the eye, in copies and to screen readers.
  void setWorkingWithoutNumbers(const Working &working);
  /// Takes the fields away, with what was typed: it was about other lines. Followed by setWorking.
  void forgetAnswers();
  void setTheme(const Theme &theme);
  /// The colour of marked terms, asked for at every painting.
  void setInkOf(std::function<QColor(const QString &markId)> inkOf);
  /// The working with all its lines, of which only some may be shown: numbers are followed through it. It is
  /// asked for when they are; without it they are followed through the lines that are shown.
  void setWholeWorking(std::function<Working()> working);
  /// The terms of these marks stand out.
  void setHighlighted(std::set<std::string> markIds);
  /// Lets go of the number that was traced or chosen.
  void endTrace();
  /// What the traced number came from; empty when there is none, or it is not shown.
  [[nodiscard]] const Provenance &traced() const { return m_traced; }

  /// Ends a scrub, and enters the number that is typed and not entered yet. Why it is refused; else empty.
  [[nodiscard]] QString enterTyped();
  /// Takes back what is typed and refused.
  void dropTyped() { closeNumberField(); }

  /// Gives the focus to the first field, or to the panel where there is none.
  void focusField();

  /// The numbers that can be touched, in the coordinates of the whole working.
  [[nodiscard]] ShownNumbers shownNumbers() const { return {m_lines, m_placed}; }
  /// What is shown and where, in coordinates of the viewport.
  [[nodiscard]] PlacedWorking placed() const;
  /// The lines as LaTeX, one below the other.
  [[nodiscard]] QString latexOfAll() const;

  [[nodiscard]] QSize sizeHint() const override;

signals:
  /// The pointer is on a term of this mark, or (empty) on none.
  void markHovered(const QString &markId);
  /// The learner has filled in a line, as 10, 10/3, 2*sqrt(43)/3 …
  void answered(const QString &lineId, const QString &text);
  /// … or wants to see it.
  void showRequested(const QString &lineId);
  /// Another number is traced, or it came from something else; see traced().
  void traceChanged();

  // A number in a formula that is a coordinate is changed, as the signals of NumberField say.
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
  bool viewportEvent(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void contextMenuEvent(QContextMenuEvent *event) override;
  void scrollContentsBy(int dx, int dy) override;

private:
  void showLines(const Working &working);
  void typesetLines();
  [[nodiscard]] Typesetter::Picture pictureOf(const math::Row &formula) const;
  void setPiece(TypesetLine &line, LinePiece piece, TraceableFormula formula) const;
  /// Takes what looks as it did before from before.
  [[nodiscard]] TypesetLine typeset(const WorkingLine &line) const;
  [[nodiscard]] TypesetLine typesetPartially(const WorkingLine &line) const;
  void placeLines();
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
  void moveFields();
  void addField(const WorkingLine &line, const Gap &gap);
  static void dropField(BlankField &field);
  void updateAccessibleText();
  void hover(const QString &markId);
  void hoverNumber(std::optional<NumberPlace> number);
  void setCurrentLine(std::optional<std::size_t> line);
  void scrollTo(const QRectF &box);
  // Whether the key had a meaning.
  bool stepByKey(int key);
  bool stepLine(int way);
  void copy(const QString &text) const;
  [[nodiscard]] QPointF scrolled() const;
  [[nodiscard]] std::optional<std::size_t> lineAt(QPointF position) const;
  [[nodiscard]] QString markAt(QPointF position) const;
  [[nodiscard]] QColor inkOf(const QString &markId) const;

  void connectScrub();
  void pressNumber(const NumberPlace &number, const QMouseEvent &event);
  void trace(const NumberPlace &number);
  /// What depends on where the numbers stand and what they are: the trace, and the field over one.
  void followNumbers();
  [[nodiscard]] Working wholeWorking() const;
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
  void paintBlank(QPainter &painter, const QRectF &blank) const;
  void paintRemark(QPainter &painter, const PlacedLine &line, const LineRemark &remark) const;

  const Typesetter &m_typesetter;
  Theme m_theme;
  std::function<QColor(const QString &)> m_inkOf;
  std::set<std::string> m_highlighted;
  Working m_working;
  Fade m_fade;
  bool m_asks = true; ///< whether gaps have fields
  std::map<std::string, LineRemark> m_remarks;
  std::map<std::string, BlankField *> m_fields; ///< by the lines' ids
  std::vector<TypesetLine> m_lines;
  SentenceBreaker m_sentences;
  PlacedWorking m_placed;
  QString m_hovered;
  std::optional<std::size_t> m_current; ///< the line that was clicked or reached by the keys

  std::function<Working()> m_wholeWorking;
  std::optional<NumberPlace> m_hoveredNumber;
  std::optional<NumberPlace> m_pressedNumber; ///< until the button is up, or its scrub ends
  std::optional<NumberPlace> m_chosenNumber;  ///< by the keys
  std::optional<NumberPlace> m_tracedNumber;
  Provenance m_traced;
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
