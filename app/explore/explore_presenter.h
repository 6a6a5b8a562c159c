// Explore: the list of the scene, and one selection for list, picture and worked lines.
#pragma once

#include "widgets/scene_selection.h"
#include "widgets/session_model.h"

#include <set>

class QMenu;

namespace halfspace {

class MarkHighlights;
class SceneView;
class WindowPanels;

/// Shows the list while Explore is open, and keeps together what is selected: in the list, in the
/// picture, by its handles, and with its working.
class ExplorePresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it but the parent.
  ExplorePresenter(SessionModel &model, WindowPanels &panels, MarkHighlights &highlights, QObject *parent);

private:
  void takeLesson();
  void takeScene();
  /// Somebody has clicked on a mark of the picture; with `adds` what it is of comes to what is selected.
  void choose(const QString &mark, bool adds);
  void takeHandle();
  void showSelection();
  void selectHandle();
  void showWorkings();
  void addPin(QMenu &menu, const QString &name);

  SessionModel &m_model;
  WindowPanels &m_panels;
  MarkHighlights &m_highlights;
  SceneSelection &m_selection;
  std::set<std::string> m_pinned; ///< constructions whose working stays
  std::size_t m_entries = 0;      ///< of the scene, when it was shown last
};

} // namespace halfspace
