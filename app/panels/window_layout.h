// How the window's room is shared between the scene and the page.
#pragma once

#include "app/settings.h"
#include "widgets/picture/theme.h"

#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;
class QSplitter;

namespace halfspace {

class LessonPage;
class WindowPanels;

/// Shares the room as it suits the window until the user has moved the split; shows the scene alone, the page
/// alone, or both; fills the screen. Type on a page that stands alone grows with it.
class WindowLayout : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  WindowLayout(QMainWindow &window, WindowPanels &panels);

  /// The window has another size.
  void takeSize();
  /// The theme of the page, but for the size of its type where it stands alone.
  void setPageTheme(const Theme &theme);
  /// Scene only, page only, full screen, and as it was at first.
  [[nodiscard]] QList<QAction *> actions() const;

  /// Size and place of the window, as it is stored or as it suits the screen.
  void takeGeometry(const Settings &settings);
  /// The arrangement of the panels in it.
  void takePanels(const Settings &settings);
  /// All of it. The next start is a window again: full screen ends.
  void put(Settings &settings);

signals:
  void sizeTaken(); ///< scene and page have their new sizes

private:
  enum class Parts { Both, SceneOnly, PageOnly };
  void showParts(Parts parts);
  void setFullScreen(bool on);
  void restore();
  void share();
  /// How much larger its type is where the page stands alone.
  [[nodiscard]] double pageTypeScale() const;
  void showPage();
  [[nodiscard]] QAction *addChoice(const QString &text, const QKeySequence &key);

  QMainWindow &m_window;
  QSplitter &m_split;           ///< between the scene and the page
  bool m_isSplitChosen = false; ///< the user has moved it
  QWidget &m_scene;
  QWidget &m_side; ///< has the page in it
  LessonPage &m_page;
  Theme m_pageTheme;
  double m_pageTypeScale = 1; ///< as it is shown
  QDockWidget &m_numbersDock;
  QAction *m_sceneOnly;
  QAction *m_pageOnly;
  QAction *m_fullScreen;
  QAction *m_restore;
};

} // namespace halfspace
