// What the window is made of.
#pragma once

#include "app/panels/messages.h"

#include <memory>

class QDockWidget;
class QMainWindow;
class QSplitter;

namespace halfspace {

class ContentsDrawer;
class ExplorePanel;
class Inspector;
class LessonPage;
class SceneColumn;
class SessionModel;
class Typesetter;
class UnfinishedInput;
class WorkingPractice;
struct Theme;

/// Makes the scene and the page beside each other, the dock with all numbers, and the drawer with the
/// contents. The widgets belong to the window, but go before what they look at.
class WindowPanels {
  Q_DECLARE_TR_FUNCTIONS(halfspace::WindowPanels)
public:
  /// The model must outlive the panels.
  WindowPanels(QMainWindow &window, SessionModel &model);
  ~WindowPanels();
  WindowPanels(const WindowPanels &) = delete;
  WindowPanels &operator=(const WindowPanels &) = delete;

  [[nodiscard]] const Typesetter &typesetter() const { return *m_typesetter; }
  [[nodiscard]] SceneColumn &scene() { return *m_scene; }
  [[nodiscard]] WorkingPractice &practice() { return *m_practice; }
  [[nodiscard]] LessonPage &page() { return *m_page; }
  /// Above the page, in Explore.
  [[nodiscard]] ExplorePanel &explore() { return *m_explore; }
  /// Between the list of Explore and the page below it.
  [[nodiscard]] QSplitter &side() { return *m_side; }
  /// Between the scene and the side.
  [[nodiscard]] QSplitter &split() { return *m_split; }
  [[nodiscard]] Inspector &inspector() { return *m_inspector; }
  [[nodiscard]] QDockWidget &numbersDock() { return *m_numbersDock; }
  [[nodiscard]] ContentsDrawer &contents() { return *m_contents; }

  /// For whoever has something to tell.
  [[nodiscard]] Messages messages();
  /// What is held or typed in any of the panels.
  [[nodiscard]] UnfinishedInput &input() { return *m_input; }
  /// Of all panels but the page; see SceneColumn.
  void setLook(const Theme &theme, double sizeScale, const Theme &panels);

private:
  std::unique_ptr<Typesetter> m_typesetter;
  QMainWindow &m_window;
  SceneColumn *m_scene;
  WorkingPractice *m_practice;
  LessonPage *m_page; ///< has the practice in it
  ExplorePanel *m_explore;
  QSplitter *m_side; ///< has both in it
  QSplitter *m_split;
  Inspector *m_inspector = nullptr;
  QDockWidget *m_numbersDock = nullptr; ///< has the inspector in it
  ContentsDrawer *m_contents = nullptr;
  std::unique_ptr<UnfinishedInput> m_input;
};

} // namespace halfspace
