#include "app/export/parts_section.h"

#include "app/panels/part_title.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>

namespace halfspace {
namespace {

constexpr int columns = 2;

} // namespace

PartsSection::PartsSection(bool hasFlat) : ExportSection(tr("Shown")), m_hasFlat(hasFlat) {
  auto *grid = new QGridLayout;
  for (std::size_t i = 0; i < m_boxes.size(); ++i) {
    const auto &[name, part] = shownPartNames[i];
    m_boxes[i] = new QCheckBox(partTitle(part));
    m_boxes[i]->setObjectName(QString::fromUtf8(name.data(), static_cast<int>(name.size())));
    grid->addWidget(m_boxes[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
    connect(m_boxes[i], &QCheckBox::toggled, this, &PartsSection::changed);
  }
  form().addRow(grid);
}

void PartsSection::fill(const ExportChoices &choices) {
  for (std::size_t i = 0; i < m_boxes.size(); ++i)
    m_boxes[i]->setChecked(choices.shown.*shownPartNames[i].part);
}

void PartsSection::enableFor(const ExportChoices &choices) {
  const bool isFlat = choices.isFlat && m_hasFlat; // which has labels alone
  for (std::size_t i = 0; i < m_boxes.size(); ++i) {
    const auto part = shownPartNames[i].part;
    const bool isPossible =
        part == &ShownParts::labels || (part == &ShownParts::coordinates ? choices.shown.labels : !isFlat);
    m_boxes[i]->setEnabled(isPossible);
  }
}

void PartsSection::put(ExportChoices &choices) const {
  for (std::size_t i = 0; i < m_boxes.size(); ++i)
    choices.shown.*shownPartNames[i].part = m_boxes[i]->isChecked();
}

} // namespace halfspace
