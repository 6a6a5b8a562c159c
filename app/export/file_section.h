// The format of a figure's file, and how large the figure is.
#pragma once

#include "app/export/export_section.h"

class QSpinBox;

namespace halfspace {

class MeasureField;

class FileSection : public ExportSection {
  Q_OBJECT
public:
  FileSection();

  void fill(const ExportChoices &choices) override;
  void enableFor(const ExportChoices &choices) override;
  void put(ExportChoices &choices) const override;

private:
  void addPaperFields();
  void addPixelFields();
  /// A field for a whole number.
  [[nodiscard]] QSpinBox *addSpinBox(const QString &words, const QString &name, int least, int most, int step,
                                     const QString &unit);

  QComboBox *m_format;
  QComboBox *m_measure; ///< true: on paper
  MeasureField *m_width = nullptr;
  MeasureField *m_type = nullptr;
  QSpinBox *m_pixelsPerInch = nullptr;
  QSpinBox *m_pixelsAcross = nullptr;
};

} // namespace halfspace
