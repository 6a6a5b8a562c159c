#include "widgets/flow_layout.h"

#include <QStyle>
#include <QWidget>

#include <algorithm>

namespace halfspace {

FlowLayout::FlowLayout(QWidget *parent) : QLayout(parent) {}

FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem *item) { m_items.emplace_back(item); }

int FlowLayout::count() const { return static_cast<int>(m_items.size()); }

QLayoutItem *FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem *FlowLayout::takeAt(int index) {
  if (!itemAt(index))
    return nullptr;
  QLayoutItem *taken = m_items[static_cast<std::size_t>(index)].release();
  m_items.erase(m_items.begin() + index);
  return taken;
}

std::vector<QRect> FlowLayout::placesIn(int width) const {
  std::vector<QRect> places(m_items.size());
  QPoint next;
  std::size_t rowBegin = 0;
  int rowHeight = 0;
  for (std::size_t i = 0; i < m_items.size(); ++i) {
    if (m_items[i]->isEmpty())
      continue;
    QSize size = m_items[i]->sizeHint().boundedTo({std::max(width, 0), QWIDGETSIZE_MAX});
    if (m_items[i]->hasHeightForWidth())
      size.setHeight(m_items[i]->heightForWidth(size.width()));
    if (next.x() > 0 && next.x() + size.width() > width) {
      next = {0, next.y() + rowHeight + spacing()};
      rowBegin = i;
      rowHeight = 0;
    }
    places[i] = {next, size};
    next.rx() += size.width() + spacing();
    rowHeight = std::max(rowHeight, size.height());
    for (std::size_t inRow = rowBegin; inRow <= i; ++inRow)
      if (!places[inRow].isNull())
        places[inRow].setHeight(rowHeight);
  }
  return places;
}

int FlowLayout::heightForWidth(int width) const {
  const QMargins margins = contentsMargins();
  int height = 0;
  for (const QRect &place : placesIn(width - margins.left() - margins.right()))
    height = std::max(height, place.bottom() + 1);
  return height + margins.top() + margins.bottom();
}

QSize FlowLayout::minimumSize() const {
  QSize least;
  for (const auto &item : m_items)
    least = least.expandedTo(item->minimumSize());
  const QMargins margins = contentsMargins();
  return least + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

QSize FlowLayout::sizeHint() const {
  const QMargins margins = contentsMargins();
  int right = 0;
  for (const QRect &place : placesIn(QWIDGETSIZE_MAX))
    right = std::max(right, place.right() + 1);
  const int width = right + margins.left() + margins.right();
  return {width, heightForWidth(width)};
}

void FlowLayout::setGeometry(const QRect &rect) {
  QLayout::setGeometry(rect);
  const QRect room = rect.marginsRemoved(contentsMargins());
  const std::vector<QRect> places = placesIn(room.width());
  const auto direction = parentWidget() ? parentWidget()->layoutDirection() : Qt::LeftToRight;
  for (std::size_t i = 0; i < m_items.size(); ++i)
    if (!places[i].isNull())
      m_items[i]->setGeometry(QStyle::visualRect(direction, room, places[i].translated(room.topLeft())));
}

} // namespace halfspace
