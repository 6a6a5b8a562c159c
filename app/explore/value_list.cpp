#include "app/explore/value_list.h"

#include <QAbstractItemView>
#include <QStyle>

namespace halfspace {
namespace {

/// A longer list is scrolled.
constexpr int mostSeen = 12;

} // namespace

ValueList::ValueList() {
  addItem(tr("Values"));
  setMaxVisibleItems(mostSeen);
  setStyleSheet("QComboBox { combobox-popup: 0; }"); // else as many are shown as the screen has room for
  setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(tr("Values").size());
  connect(this, qOverload<int>(&QComboBox::activated), this, [this](int value) {
    const QString name = itemData(value).toString();
    setCurrentIndex(0);
    if (!name.isEmpty())
      emit taken(name);
  });
}

void ValueList::showPopup() {
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  view()->setMinimumWidth(view()->sizeHintForColumn(0) + 2 * bar);
  QComboBox::showPopup();
}

void ValueList::add(const QString &text, const std::string &name) {
  addItem(text, QString::fromStdString(name));
}

} // namespace halfspace
