// What stands beside a scene in Explore, above the worked lines.
#pragma once

#include "widgets/explore/entry_list.h"

class QLabel;

namespace halfspace {

class DiscoveryBox;
class FitsBox;
class NumberSlider;

/// The list of what is in the scene, with words in its place while there is nothing, and what can be made of
/// it. It has what is selected there, and what is done there.
class ExplorePanel : public QWidget {
  Q_OBJECT
public:
  /// The model must outlive it.
  explicit ExplorePanel(SessionModel &model, QWidget *parent = nullptr);

  [[nodiscard]] SceneSelection &selection() { return *m_selection; }
  [[nodiscard]] EntryEdits &edits() { return *m_edits; }
  [[nodiscard]] EntryList &list() { return *m_list; }
  [[nodiscard]] FitsBox &fits() { return *m_fits; }
  void setTheme(const Theme &theme);

private:
  void showScene();

  const SessionModel &m_model;
  SceneSelection *m_selection;
  EntryEdits *m_edits;
  EntryList *m_list;
  NumberSlider *m_slider;
  FitsBox *m_fits;
  QWidget *m_offers; ///< what fits, and what holds
  QLabel *m_welcome;
};

} // namespace halfspace
