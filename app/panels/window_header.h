// What stands in the row of the menus: the way to the contents, and the lesson's title.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/session_model.h"

class QLabel;
class QMenuBar;
class QToolButton;

namespace halfspace {

class ContentsDrawer;

/// The button follows the drawer. The title is there where there is room beside the menus.
class WindowHeader : public QObject {
  Q_OBJECT
public:
  /// Both stand in the menu bar, and it lives as long as that. All others must outlive it.
  WindowHeader(QMenuBar &menus, const SessionModel &model, ContentsDrawer &contents);

  /// Writes the title, or takes it away. To be told of every size of the window.
  void showTitle();
  void setTheme(const Theme &theme);

signals:
  void contentsWanted();

private:
  QMenuBar &m_menus;
  const SessionModel &m_model;
  QToolButton *m_contentsButton;
  QLabel *m_title;
};

} // namespace halfspace
