#include "app/export/file_section.h"

#include "app/export/measure_field.h"
#include "app/figures/figure_words.h"
#include "widgets/scene/offscreen.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSpinBox>

#include <algorithm>

namespace halfspace {
namespace {

constexpr double widthStep = 0.5;
constexpr double typeStep = 0.5;
constexpr int pixelStep = 50;

QList<std::pair<QString, QVariant>> formatItems() {
  QList<std::pair<QString, QVariant>> items;
  for (const FigureFormat &format : figureFormats()) {
    const QString name = QString::fromStdString(format.name);
    items << std::pair(format.vectors ? FileSection::tr("%1: vectors").arg(name)
                                      : FileSection::tr("%1: pixels").arg(name),
                       QString::fromStdString(format.ending));
  }
  return items;
}

} // namespace

FileSection::FileSection()
    : ExportSection(tr("File")), m_format(&addCombo(tr("&Format"), "format", formatItems())),
      m_measure(
          &addCombo(tr("&Measured in"), "measure", {{tr("centimetres"), true}, {tr("pixels"), false}})) {
  addPaperFields();
  addPixelFields();
}

void FileSection::addPaperFields() {
  const auto add = [this](const QString &words, const QString &name, const QString &unit, double least,
                          double most, double step) {
    auto *field = new MeasureField(unit, least, most, step);
    field->setObjectName(name);
    form().addRow(words, field);
    connect(field, qOverload<double>(&MeasureField::valueChanged), this, &FileSection::changed);
    return field;
  };
  m_width = add(tr("&Width"), "width", tr(" cm"), leastWidth / pointsPerCentimetre,
                mostWidth / pointsPerCentimetre, widthStep);
  m_type = add(tr("T&ype"), "typeSize", tr(" pt"), leastType, mostType, typeStep);
}

void FileSection::addPixelFields() {
  m_pixelsPerInch = addSpinBox(tr("&Resolution"), "pixelsPerInch", static_cast<int>(leastPixelsPerInch),
                               static_cast<int>(mostPixelsPerInch), pixelStep, tr(" dpi"));
  m_pixelsAcross = addSpinBox(tr("Width in pixe&ls"), "pixelsAcross", leastPixelsAcross, maxPictureSide,
                              pixelStep, tr(" px"));
}

QSpinBox *FileSection::addSpinBox(const QString &words, const QString &name, int least, int most, int step,
                                  const QString &unit) {
  auto *field = new QSpinBox;
  field->setObjectName(name);
  field->setRange(least, most);
  field->setSingleStep(step);
  field->setSuffix(unit);
  form().addRow(words, field);
  connect(field, qOverload<int>(&QSpinBox::valueChanged), this, &FileSection::changed);
  return field;
}

void FileSection::fill(const ExportChoices &choices) {
  choose(*m_format, QString::fromStdString(choices.ending));
  choose(*m_measure, choices.isOnPaper);
  m_width->setValue(choices.paper.width / pointsPerCentimetre);
  m_type->setValue(choices.paper.typeSize);
  m_pixelsPerInch->setValue(qRound(choices.paper.pixelsPerInch));
  m_pixelsAcross->setValue(choices.pixelsAcross);
}

void FileSection::enableFor(const ExportChoices &choices) {
  const bool isOfPixels = !choices.format().vectors;
  const bool isOnPaper = choices.isOnPaper || !isOfPixels;
  m_measure->setEnabled(isOfPixels);
  m_width->setEnabled(isOnPaper);
  m_type->setEnabled(isOnPaper);
  m_type->setMaximum(std::min(mostType, choices.paper.width * mostTypePerWidth));
  m_pixelsPerInch->setEnabled(isOfPixels && isOnPaper);
  m_pixelsAcross->setEnabled(!isOnPaper);
}

void FileSection::put(ExportChoices &choices) const {
  choices.ending = m_format->currentData().toString().toStdString();
  choices.isOnPaper = m_measure->currentData().toBool();
  choices.paper = {m_width->value() * pointsPerCentimetre, m_type->value(),
                   static_cast<double>(m_pixelsPerInch->value())};
  choices.pixelsAcross = m_pixelsAcross->value();
}

} // namespace halfspace
