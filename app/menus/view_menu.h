// View: the camera, the look of the window, and which parts of it are shown.
#pragma once

#include "app/panels/messages.h"

#include <QMenu>

namespace halfspace {

class CameraActions;
class DrawnFigure;
class WindowLayout;
class WindowLook;
class WindowPanels;

class ViewMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  ViewMenu(const CameraActions &camera, WindowLook &look, const WindowLayout &layout, WindowPanels &panels,
           QWidget *parent);

private:
  void addSizeMenu(WindowLook &look, Messages messages);
  void addThemeMenu(WindowLook &look);
  /// Which parts of the picture are drawn.
  void addPartsMenu(DrawnFigure &drawn);
};

} // namespace halfspace
