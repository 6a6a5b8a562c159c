// The 3D view with what lies over it: the card of the selected object and a few tools.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/view/tool_icons.h"

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace halfspace {

class FlatView;
class NumberCard;
class SceneView;

/// Keeps the card in the view's lower left corner, a flat picture in the lower right one, the tools in the
/// upper right one, and tells the view what they cover. In the upper left one stands what the view does not
/// draw; it comes and goes with the view, which does not make way for it.
class SceneFrame : public QWidget {
  Q_OBJECT
public:
  /// View and card become its own.
  SceneFrame(SceneView &view, NumberCard &card, QWidget *parent = nullptr);

  /// Puts a flat picture into the lower right corner, where there is one to show; it becomes its own.
  void setFlatView(FlatView &flat);
  /// A button that does what the action does.
  void addTool(QAction &action, ToolIcon icon);
  void setTheme(const Theme &theme);

protected:
  void resizeEvent(QResizeEvent *event) override;
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  struct Tool {
    QToolButton *button;
    ToolIcon icon;
  };
  void showNotice(const QString &words);
  void placeNotice();
  void arrange();

  SceneView &m_view;
  NumberCard &m_card;
  FlatView *m_flat = nullptr;
  QWidget *m_tools;
  QLabel *m_notice;
  std::vector<Tool> m_buttons;
};

} // namespace halfspace
