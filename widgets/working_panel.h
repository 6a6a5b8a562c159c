// The worked lines beside the picture.
#pragma once

#include "widgets/scene/theme.h"
#include "widgets/working_layout.h"

#include <QAbstractScrollArea>

#include <functional>
#include <optional>

namespace halfspace {

/// Shows a working as a textbook would: formulas, their numbers, a sentence. A working appears only when all
/// of its formulas are typeset, so lines of different moments never stand together; until then the last one
/// stays.
class WorkingPanel : public QAbstractScrollArea {
  Q_OBJECT
public:
  /// The typesetter must outlive the panel.
  explicit WorkingPanel(Typesetter &typesetter, QWidget *parent = nullptr);
  ~WorkingPanel() override;

  void setWorking(const Working &working);
  void setTheme(const Theme &theme);
  /// The colour of marked terms, asked for at every painting.
  void setInkOf(std::function<QColor(const QString &markId)> inkOf);
  /// The terms of these marks stand out.
  void setHighlighted(std::set<std::string> markIds);
  /// These lines show a blank instead of numbers and result, to the eye, in copies and to screen readers.
  void setBlanked(std::set<std::string> lineIds);

  /// Whether the newest working is shown.
  [[nodiscard]] bool isSettled() const { return !m_requested && !m_waiting; }
  /// What is shown and where, in coordinates of the viewport.
  [[nodiscard]] PlacedWorking placed() const;
  /// The line as LaTeX, or all lines one below the other.
  [[nodiscard]] QString latexOf(const WorkingLine &line) const;
  [[nodiscard]] QString latexOfAll() const;

  [[nodiscard]] QSize sizeHint() const override;

signals:
  /// The pointer is on a term of this mark, or (empty) on none.
  void markHovered(const QString &markId);

protected:
  void paintEvent(QPaintEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void changeEvent(QEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  bool viewportEvent(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void contextMenuEvent(QContextMenuEvent *event) override;

private:
  void request(const Working &working);
  void showRequested();
  void placeLines();
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

  Typesetter &m_typesetter;
  Typesetter::Request m_request;
  Theme m_theme;
  std::function<QColor(const QString &)> m_inkOf;
  std::set<std::string> m_highlighted;
  std::set<std::string> m_blanked;
  std::optional<Working> m_requested; ///< whose formulas are being made
  std::optional<Working> m_waiting;   ///< the newest, if newer than that
  std::vector<TypesetLine> m_lines;   ///< what is shown
  PlacedWorking m_placed;
  QString m_hovered;
  std::optional<std::size_t> m_current; ///< the line that was clicked or reached by the keys
};

} // namespace halfspace
