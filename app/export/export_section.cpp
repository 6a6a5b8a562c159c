#include "app/export/export_section.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {

ExportSection::ExportSection(const QString &heading) : m_form(new QFormLayout) {
  auto *words = new QLabel(heading);
  words->setObjectName("heading");
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(words);
  column->addLayout(m_form);
  m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

std::vector<QWidget *> ExportSection::words() const {
  std::vector<QWidget *> labels;
  for (int row = 0; row < m_form->rowCount(); ++row)
    if (QLayoutItem *label = m_form->itemAt(row, QFormLayout::LabelRole))
      labels.push_back(label->widget());
  return labels;
}

int ExportSection::wordsWidth() const {
  int width = 0;
  for (const QWidget *label : words())
    width = std::max(width, label->sizeHint().width());
  return width;
}

void ExportSection::setWordsWidth(int width) {
  for (QWidget *label : words())
    label->setMinimumWidth(width);
}

QComboBox &ExportSection::addCombo(const QString &words, const QString &name,
                                   const QList<std::pair<QString, QVariant>> &items) {
  auto *combo = new QComboBox;
  combo->setObjectName(name);
  for (const auto &[text, meaning] : items)
    combo->addItem(text, meaning);
  m_form->addRow(words, combo);
  connect(combo, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportSection::changed);
  return *combo;
}

void choose(QComboBox &combo, const QVariant &meaning) { combo.setCurrentIndex(combo.findData(meaning)); }

} // namespace halfspace
