#include "app/export/preview_pane.h"

#include "widgets/mouse_place.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace halfspace {
namespace {

/// Around the page, and its squares where it is transparent, in the widget's pixels.
constexpr int margin = 12;
constexpr int squareSide = 8;
constexpr QRgb lightSquare = qRgb(255, 255, 255);
constexpr QRgb darkSquare = qRgb(222, 222, 222);

/// Two light and two dark squares.
QPixmap squares() {
  QPixmap tile(2 * squareSide, 2 * squareSide);
  tile.fill(QColor(lightSquare));
  QPainter painter(&tile);
  painter.fillRect(0, 0, squareSide, squareSide, QColor(darkSquare));
  painter.fillRect(squareSide, squareSide, squareSide, squareSide, QColor(darkSquare));
  return tile;
}

} // namespace

class PreviewPane::Page : public QWidget {
public:
  explicit Page(PreviewPane &pane) : m_pane(pane) { setMouseTracking(true); }

  void setPreview(QImage image, bool isTransparent) {
    m_image = std::move(image);
    m_isTransparent = isTransparent;
    updateGeometry();
    update();
  }

  [[nodiscard]] QSize sizeHint() const override { return imageSize() + QSize(2 * margin, 2 * margin); }
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  void paintEvent(QPaintEvent *) override {
    if (m_image.isNull())
      return;
    const QRect page = pageRoom();
    QPainter painter(this);
    if (m_isTransparent)
      painter.drawTiledPixmap(page, squares());
    else
      painter.fillRect(page, Qt::white);
    painter.drawImage(page, m_image);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(page.adjusted(-1, -1, 0, 0));
  }

  void mousePressEvent(QMouseEvent *event) override {
    if (event->button() == Qt::LeftButton)
      emit m_pane.pressed(partAt(mousePlace(*event)));
  }
  void mouseMoveEvent(QMouseEvent *event) override {
    if (event->buttons() & Qt::LeftButton)
      emit m_pane.dragged(partAt(mousePlace(*event)));
    else
      emit m_pane.hovered(partAt(mousePlace(*event)));
  }
  void mouseReleaseEvent(QMouseEvent *event) override {
    if (event->button() == Qt::LeftButton)
      emit m_pane.released();
  }
  void contextMenuEvent(QContextMenuEvent *event) override {
    emit m_pane.menuWanted(partAt(event->pos()), event->globalPos());
  }

private:
  /// The middle of the widget.
  [[nodiscard]] QRect pageRoom() const {
    QRect page({}, imageSize());
    page.moveCenter(rect().center());
    return page;
  }
  [[nodiscard]] QPointF partAt(QPointF place) const {
    const QRect page = pageRoom();
    const QPointF inside = place - page.topLeft();
    return {inside.x() / std::max(1, page.width()), inside.y() / std::max(1, page.height())};
  }
  /// In the widget's pixels.
  [[nodiscard]] QSize imageSize() const { return (QSizeF(m_image.size()) / devicePixelRatioF()).toSize(); }

  PreviewPane &m_pane;
  QImage m_image;
  bool m_isTransparent = false;
};

PreviewPane::PreviewPane(QWidget *parent) : QScrollArea(parent), m_page(new Page(*this)) {
  setObjectName("preview");
  setWidget(m_page);
  setWidgetResizable(true);
  setAlignment(Qt::AlignCenter);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Preview"));
}

void PreviewPane::setPreview(const FigurePreview &preview, bool isTransparent) {
  m_page->setPreview(preview.image, isTransparent);
}

void PreviewPane::setActualSize(bool isActual) {
  m_isActualSize = isActual;
  emit roomChanged();
}

void PreviewPane::setHand(bool isOver, bool isHolding) {
  m_page->setCursor(isHolding ? Qt::ClosedHandCursor : isOver ? Qt::OpenHandCursor : Qt::ArrowCursor);
}

PreviewRoom PreviewPane::room() const {
  const QSize inside = maximumViewportSize() - QSize(2 * margin, 2 * margin);
  PreviewRoom room{(QSizeF(inside.expandedTo({1, 1})) * devicePixelRatioF()).toSize()};
  if (m_isActualSize)
    room.pixelsPerInch = logicalDpiX() * devicePixelRatioF();
  return room;
}

void PreviewPane::resizeEvent(QResizeEvent *event) {
  QScrollArea::resizeEvent(event);
  if (!m_isActualSize)
    emit roomChanged();
}

void PreviewPane::keyPressEvent(QKeyEvent *event) {
  if (event->matches(QKeySequence::Delete))
    emit removeWanted();
  else
    QScrollArea::keyPressEvent(event);
}

} // namespace halfspace
