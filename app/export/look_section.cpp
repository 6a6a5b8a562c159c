#include "app/export/look_section.h"

#include "app/panels/theme_title.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>

namespace halfspace {
namespace {

QList<std::pair<QString, QVariant>> themeItems() {
  QList<std::pair<QString, QVariant>> items;
  for (const Theme &theme : themes()) {
    const QString name = QString::fromStdString(theme.name);
    items << std::pair(themeTitle(name), name);
  }
  return items;
}

} // namespace

LookSection::LookSection(bool hasFlat)
    : ExportSection(tr("Figure")), m_hasFlat(hasFlat),
      m_framing(&addCombo(tr("Fr&aming"), "framing",
                          {{tr("as on the screen"), false}, {tr("cropped to what is drawn"), true}})),
      m_theme(&addCombo(tr("&Theme"), "theme", themeItems())),
      m_hidden(&addCombo(tr("&Hidden parts"), "hidden",
                         {{tr("dashed"), static_cast<int>(HiddenLines::Dashed)},
                          {tr("paler"), static_cast<int>(HiddenLines::Paler)},
                          {tr("left out"), static_cast<int>(HiddenLines::LeftOut)}})),
      m_text(&addCombo(tr("Te&xt"), "text",
                       {{tr("as shapes"), static_cast<int>(TextAs::Shapes)},
                        {tr("as letters"), static_cast<int>(TextAs::Letters)}})),
      m_transparent(addCheckBox(tr("Tra&nsparent background"), "transparent")),
      m_flat(addCheckBox(tr("Flat &picture"), "flat")) {
  m_flat->setVisible(hasFlat);
}

QCheckBox *LookSection::addCheckBox(const QString &words, const QString &name) {
  auto *box = new QCheckBox(words);
  box->setObjectName(name);
  form().addRow(box);
  connect(box, &QCheckBox::toggled, this, &LookSection::changed);
  return box;
}

void LookSection::fill(const ExportChoices &choices) {
  choose(*m_framing, choices.isCropped);
  choose(*m_theme, QString::fromStdString(choices.theme));
  choose(*m_hidden, static_cast<int>(choices.hidden));
  choose(*m_text, static_cast<int>(choices.text));
  m_transparent->setChecked(choices.isTransparent);
  m_flat->setChecked(choices.isFlat);
}

void LookSection::enableFor(const ExportChoices &choices) {
  const ExportFormat *vectors = choices.format().vectors;
  const bool isFlat = choices.isFlat && m_hasFlat; // there nothing is hidden
  m_hidden->setEnabled(vectors && !isFlat);
  m_text->setEnabled(vectors && vectors->choosesText);
}

void LookSection::put(ExportChoices &choices) const {
  choices.isCropped = m_framing->currentData().toBool();
  choices.theme = m_theme->currentData().toString().toStdString();
  choices.hidden = static_cast<HiddenLines>(m_hidden->currentData().toInt());
  choices.text = static_cast<TextAs>(m_text->currentData().toInt());
  choices.isTransparent = m_transparent->isChecked();
  choices.isFlat = m_flat->isChecked();
}

} // namespace halfspace
