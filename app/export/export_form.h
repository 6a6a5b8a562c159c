// All choices of the export window, one below the other.
#pragma once

#include "app/export/export_section.h"

#include <QScrollArea>

#include <vector>

namespace halfspace {

class ExportForm : public QScrollArea {
  Q_OBJECT
public:
  /// `hasFlat`: there is a flat picture to choose.
  ExportForm(bool hasFlat, QWidget *parent);

  /// Fills all fields, and tells of no change.
  void fill(const ExportChoices &choices);
  [[nodiscard]] const ExportChoices &choices() const { return m_choices; }
  /// Where nothing of it needs to be scrolled to.
  [[nodiscard]] int wholeHeight() const;

signals:
  void changed(); ///< by the user

private:
  void alignFields();
  void take();
  void enable();

  ExportChoices m_choices;
  std::vector<ExportSection *> m_sections;
};

} // namespace halfspace
