#include "app/explore/check_list.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {

CheckList::CheckList(const QString &heading, const std::vector<CheckItem> &items)
    : m_list(new QListWidget), m_items(items) {
  for (const CheckItem &item : items) {
    auto *row = new QListWidgetItem(item.words, m_list);
    row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    row->setCheckState(Qt::Unchecked);
  }
  auto *words = new QLabel(heading);
  words->setBuddy(m_list);
  words->setWordWrap(true);
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(words);
  column->addWidget(m_list);
  setEnabled(!items.empty());
  connect(m_list, &QListWidget::itemChanged, this, &CheckList::changed);
}

void CheckList::setChecked(const std::vector<std::string> &names) {
  for (int row = 0; row < m_list->count(); ++row) {
    const std::string &name = m_items[static_cast<std::size_t>(row)].name;
    const bool isNamed = std::find(names.begin(), names.end(), name) != names.end();
    m_list->item(row)->setCheckState(isNamed ? Qt::Checked : Qt::Unchecked);
  }
}

std::vector<std::string> CheckList::checked() const {
  std::vector<std::string> names;
  for (int row = 0; row < m_list->count(); ++row)
    if (m_list->item(row)->checkState() == Qt::Checked)
      names.push_back(m_items[static_cast<std::size_t>(row)].name);
  return names;
}

} // namespace halfspace
