// What of the picture a figure shows.
#pragma once

#include "app/export/export_section.h"

#include <array>

class QCheckBox;

namespace halfspace {

class PartsSection : public ExportSection {
  Q_OBJECT
public:
  /// `hasFlat`: there is a flat picture to choose.
  explicit PartsSection(bool hasFlat);

  void fill(const ExportChoices &choices) override;
  void enableFor(const ExportChoices &choices) override;
  void put(ExportChoices &choices) const override;

private:
  bool m_hasFlat;
  std::array<QCheckBox *, shownPartNames.size()> m_boxes{}; ///< in the order of the names
};

} // namespace halfspace
