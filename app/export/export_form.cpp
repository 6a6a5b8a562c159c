#include "app/export/export_form.h"

#include "app/export/file_section.h"
#include "app/export/look_section.h"
#include "app/export/parts_section.h"
#include "app/export/scene_section.h"

#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

constexpr double linesBetweenSections = 0.8;

} // namespace

ExportForm::ExportForm(bool hasFlat, QWidget *parent)
    : QScrollArea(parent), m_sections{new FileSection, new LookSection(hasFlat), new PartsSection(hasFlat),
                                      new SceneSection} {
  auto *page = new QWidget;
  auto *column = new QVBoxLayout(page);
  for (ExportSection *section : m_sections) {
    column->addWidget(section);
    connect(section, &ExportSection::changed, this, &ExportForm::take);
  }
  column->setSpacing(static_cast<int>(linesBetweenSections * fontMetrics().lineSpacing()));
  column->addStretch(1);
  alignFields();
  setWidget(page);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus); // its fields have it
  setFixedWidth(page->sizeHint().width() + verticalScrollBar()->sizeHint().width());
}

void ExportForm::alignFields() {
  int width = 0;
  for (const ExportSection *section : m_sections)
    width = std::max(width, section->wordsWidth());
  for (ExportSection *section : m_sections)
    section->setWordsWidth(width);
}

int ExportForm::wholeHeight() const {
  const QLayout &column = *widget()->layout(); // its notes are higher where it is narrower
  const int width = minimumWidth() - verticalScrollBar()->sizeHint().width();
  return column.hasHeightForWidth() ? column.totalHeightForWidth(width) : column.totalSizeHint().height();
}

void ExportForm::fill(const ExportChoices &choices) {
  m_choices = choices;
  for (ExportSection *section : m_sections) {
    const QSignalBlocker untold(section);
    section->fill(choices);
  }
  enable();
}

void ExportForm::take() {
  for (const ExportSection *section : m_sections)
    section->put(m_choices);
  enable();
  emit changed();
}

void ExportForm::enable() {
  for (ExportSection *section : m_sections)
    section->enableFor(m_choices);
}

} // namespace halfspace
