#include "widgets/lesson/name_list.h"

#include <QEvent>
#include <QScrollBar>
#include <QSignalBlocker>

#include <algorithm>

namespace halfspace {
namespace {

/// Above and below a name, in pixels.
constexpr int rowGap = 1;

} // namespace

NameList::NameList(QWidget *parent) : QListWidget(parent) {
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSpacing(rowGap);
}

void NameList::setNames(const QStringList &names) {
  const QSignalBlocker nothingIsTold(this);
  const QString chosen = currentItem() ? currentItem()->text() : QString();
  clear();
  addItems(names);
  if (!choose(chosen))
    setCurrentRow(0);
  fitWidest();
}

void NameList::fitWidest() {
  int widest = 0;
  for (int row = 0; row < count(); ++row)
    widest = std::max(widest, fontMetrics().horizontalAdvance(item(row)->text()));
  const int edges =
      2 * (frameWidth() + fontMetrics().averageCharWidth()) + verticalScrollBar()->sizeHint().width();
  setFixedWidth(widest + edges);
}

void NameList::changeEvent(QEvent *event) {
  QListWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange)
    fitWidest();
}

bool NameList::choose(const QString &name) {
  const auto found = findItems(name, Qt::MatchExactly);
  if (found.isEmpty())
    return false;
  setCurrentItem(found.front());
  return true;
}

} // namespace halfspace
