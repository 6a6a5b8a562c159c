// Help: what mouse and keys do, and about the program.
#pragma once

#include <QMenu>

namespace halfspace {

class HelpMenu : public QMenu {
  Q_OBJECT
public:
  /// Its pages open over the window.
  HelpMenu(QWidget &window, QWidget *parent);
};

} // namespace halfspace
