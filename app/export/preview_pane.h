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
  /// What the next preview is drawn on.
  [[nodiscard]] PreviewRoom room() const;

signals:
  void roomChanged(); ///< the preview that is shown does not suit any more

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  class Page;
  Page *m_page;
  bool m_isActualSize = false;
};

} // namespace halfspace
