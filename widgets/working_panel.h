// The worked lines beside the picture.
#pragma once

#include "widgets/scene/theme.h"
#include "widgets/working_layout.h"

#include <QAbstractScrollArea>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace halfspace {

class BlankField;

/// Shows a working as a textbook would: formulas, their numbers, a sentence.
class WorkingPanel : public QAbstractScrollArea {
  Q_OBJECT
public:
  /// The typesetter must outlive the panel.
  explicit WorkingPanel(const Typesetter &typesetter, QWidget *parent = nullptr);
  ~WorkingPanel() override;

  void setWorking(const Working &working);
  void setTheme(const Theme &theme);
  /// The colour of marked terms, asked for at every painting.
  void setInkOf(std::function<QColor(const QString &markId)> inkOf);
  /// The terms of these marks stand out.
  void setHighlighted(std::set<std::string> markIds);
  /// All lines show a blank instead of numbers and result, to the eye, in copies and to screen readers.
  void hideNumbers();
  /// These lines, and no others, do so, and have a field to be filled in; and what is said about some lines.
  void setBlanks(std::set<std::string> lineIds, std::map<std::string, LineRemark> remarks = {});

  /// Gives the focus to the first field, or to the panel where there is none.
  void focusField();

  /// What is shown and where, in coordinates of the viewport.
  [[nodiscard]] PlacedWorking placed() const;
  /// The line as LaTeX, or all lines one below the other.
  [[nodiscard]] QString latexOf(const WorkingLine &line) const;
  [[nodiscard]] QString latexOfAll() const;

  [[nodiscard]] QSize sizeHint() const override;

signals:
  /// The pointer is on a term of this mark, or (empty) on none.
  void markHovered(const QString &markId);
  /// The learner has filled in a line, as 10, 10/3, 2*sqrt(43)/3 …
  void answered(const QString &lineId, const QString &text);
  /// … or wants to see it.
  void showRequested(const QString &lineId);

protected:
  void paintEvent(QPaintEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void changeEvent(QEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  bool viewportEvent(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void contextMenuEvent(QContextMenuEvent *event) override;
  void scrollContentsBy(int dx, int dy) override;

private:
  void placeLines();
  [[nodiscard]] bool isBlank(const std::string &lineId) const;
  [[nodiscard]] std::map<std::string, LineState> lineStates() const;
  /// Makes and removes fields; whether the one that had the focus is gone.
  bool matchFields();
  void followFocus(QWidget *focused);
  void moveFields();
  void addField(const WorkingLine &line);
  void updateAccessibleText();
  void hover(const QString &markId);
  void setCurrentLine(std::optional<std::size_t> line);
  void copy(const QString &text) const;
  [[nodiscard]] QPointF scrolled() const;
  [[nodiscard]] std::optional<std::size_t> lineAt(QPointF position) const;
  [[nodiscard]] QString markAt(QPointF position) const;
  [[nodiscard]] QColor inkOf(const QString &markId) const;
  void paintLine(QPainter &painter, std::size_t index) const;
  void paintHighlights(QPainter &painter, const PlacedFormula &formula) const;
  void paintBlank(QPainter &painter, const QRectF &blank) const;
  void paintRemark(QPainter &painter, const PlacedLine &line, const LineRemark &remark) const;

  const Typesetter &m_typesetter;
  Theme m_theme;
  std::function<QColor(const QString &)> m_inkOf;
  std::set<std::string> m_highlighted;
  bool m_numbersHidden = false;
  std::set<std::string> m_blanks; ///< that have fields
  std::map<std::string, LineRemark> m_remarks;
  std::map<std::string, BlankField *> m_fields; ///< by the lines' ids
  std::vector<TypesetLine> m_lines;
  PlacedWorking m_placed;
  QString m_hovered;
  std::optional<std::size_t> m_current; ///< the line that was clicked or reached by the keys
};

} // namespace halfspace
