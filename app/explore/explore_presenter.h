// Explore: the list of the scene, and one selection for list, picture and worked lines.
#pragma once

#include "widgets/scene_selection.h"
#include "widgets/session_model.h"

#include <set>

class QKeyEvent;
class QMenu;

namespace halfspace {

class FieldPresenter;
class MarkHighlights;
class SceneView;
class WindowPanels;

/// Shows the list while Explore is open, and keeps together what is selected: in the list, in the
/// picture, by its handles, and with its working.
class ExplorePresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it but the parent.
  ExplorePresenter(SessionModel &model, WindowPanels &panels, MarkHighlights &highlights,
                   FieldPresenter &field, QObject *parent);

  /// A key that no part of the window has a use for: a letter begins a line, Delete takes away what is
  /// selected. False for one that means nothing here either.
  bool pressKey(const QKeyEvent &event);

private:
  void takeLesson();
  void takeScene();
  /// What has come to the scene, by whichever way, is selected, and in view.
  void takeEntries();
  /// Somebody has clicked on a mark of the picture; with `adds` what it is of comes to what is selected.
  void choose(const QString &mark, bool adds);
  /// Of what a mark is of, as in the list.
  void showMenu(const QString &mark);
  /// The object whose handle is selected, or was dragged.
  void takeHandle();
  void showSelection();
  void highlight();
  void selectHandle();
  /// Of what is selected and of what is kept on the page, where there is something to tell; else of what
  /// follows the selection.
  void showWorkings();
  /// The last construction that follows what is selected, or, where nothing is, the last one of all; empty
  /// for none.
  [[nodiscard]] std::vector<std::string> lastOfInterest() const;
  void addPin(QMenu &menu, const QString &name);

  SessionModel &m_model;
  WindowPanels &m_panels;
  MarkHighlights &m_highlights;
  FieldPresenter &m_field;
  SceneSelection &m_selection;
  std::set<std::string> m_pinned; ///< constructions whose working stays; some may come back by undo
  std::size_t m_entries = 0;      ///< of the scene, when it was shown last
  std::string m_last;             ///< the name of the last of them
};

} // namespace halfspace
