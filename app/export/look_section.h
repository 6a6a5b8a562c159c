// How a figure looks that goes to a file.
#pragma once

#include "app/export/export_section.h"

class QCheckBox;

namespace halfspace {

class LookSection : public ExportSection {
  Q_OBJECT
public:
  /// `hasFlat`: there is a flat picture to choose.
  explicit LookSection(bool hasFlat);

  void fill(const ExportChoices &choices) override;
  void enableFor(const ExportChoices &choices) override;
  void put(ExportChoices &choices) const override;

private:
  [[nodiscard]] QCheckBox *addCheckBox(const QString &words, const QString &name);

  bool m_hasFlat;
  QComboBox *m_framing; ///< true: cropped
  QComboBox *m_theme;
  QComboBox *m_hidden;
  QComboBox *m_text;
  QCheckBox *m_transparent;
  QCheckBox *m_flat;
};

} // namespace halfspace
