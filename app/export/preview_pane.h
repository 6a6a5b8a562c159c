// A figure on its page, before it goes to a file.
#pragma once

#include "app/export/preview_figure.h"

#include <QScrollArea>

namespace halfspace {

/// Paints a preview with a thin frame around its page; where that is transparent, on a chequerboard. What
/// does not fit is scrolled.
class PreviewPane : public QScrollArea {
  Q_OBJECT
public:
  explicit PreviewPane(QWidget *parent);

  void setPreview(const FigurePreview &preview, bool isTransparent);
  /// Whether it is to be as large as on paper, or as its pixels are, instead of as large as fits.
  void setActualSize(bool isActual);
  /// Whether the pointer looks as over something that a hand can take, or holds.
  void setHand(bool isOver, bool isHolding);
  /// What the next preview is drawn on.
  [[nodiscard]] PreviewRoom room() const;

signals:
  void roomChanged(); ///< the preview that is shown does not suit any more
  // Of the pointer, with how far through the page it is from its left and upper side, each from 0 to 1.
  void hovered(QPointF part);
  void pressed(QPointF part);
  void dragged(QPointF part);
  void released();
  void menuWanted(QPointF part, const QPoint &at); ///< `at`: on the screen
  void removeWanted();                             ///< the key was pressed

protected:
  void resizeEvent(QResizeEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;

private:
  class Page;
  Page *m_page;
  bool m_isActualSize = false;
};

} // namespace halfspace
