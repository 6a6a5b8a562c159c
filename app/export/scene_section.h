// Whether a figure's file carries the scene.
#pragma once

#include "app/export/export_section.h"

class QCheckBox;
class QLabel;

namespace halfspace {

class SceneSection : public ExportSection {
  Q_OBJECT
public:
  SceneSection();

  void fill(const ExportChoices &choices) override;
  void enableFor(const ExportChoices &choices) override;
  void put(ExportChoices &choices) const override;

private:
  QCheckBox *m_carriesSession;
  QCheckBox *m_code;
  QLabel *m_note; ///< what loses it
};

} // namespace halfspace
