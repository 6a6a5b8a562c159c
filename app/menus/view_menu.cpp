#include "app/menus/view_menu.h"

#include "app/menus/add_item.h"
#include "app/menus/camera_actions.h"
#include "app/panels/part_title.h"
#include "app/panels/scene_column.h"
#include "app/panels/theme_title.h"
#include "app/panels/window_layout.h"
#include "app/panels/window_look.h"
#include "app/panels/window_panels.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_view.h"

#include <QActionGroup>
#include <QDockWidget>

namespace halfspace {

ViewMenu::ViewMenu(const CameraActions &camera, WindowLook &look, const WindowLayout &layout,
                   WindowPanels &panels, QWidget *parent)
    : QMenu(tr("&View"), parent) {
  camera.addTo(*this);
  addSeparator();
  addSizeMenu(look, panels.messages());
  addThemeMenu(look);
  addPartsMenu(panels.scene().view().drawn());
  addAction(&look.motion());
  addSeparator();
  QAction *numbers = panels.numbersDock().toggleViewAction();
  numbers->setText(tr("All &Numbers"));
  numbers->setShortcut(QKeySequence("Ctrl+I"));
  addAction(numbers);
  QAction &flat = panels.scene().flat().unfolded();
  flat.setShortcut(QKeySequence("6"));
  addAction(&flat);
  addActions(layout.actions());
}

void ViewMenu::addSizeMenu(WindowLook &look, Messages messages) {
  QMenu &menu = *addMenu(tr("&Size of Text and Lines"));
  const auto changeBy = [&look, messages](int steps) {
    look.changeSizeBy(steps);
    messages.say(tr("Text and lines at %1 %.").arg(qRound(look.sizeScale() * 100)));
  };
  QAction *larger = addItem(menu, tr("&Larger"), {}, this, [changeBy] { changeBy(1); });
  larger->setObjectName("larger");
  larger->setShortcuts({QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")}); // with and without Shift
  QAction *smaller =
      addItem(menu, tr("&Smaller"), QKeySequence("Ctrl+-"), this, [changeBy] { changeBy(-1); });
  smaller->setObjectName("smaller");
  addItem(menu, tr("&Usual Size"), QKeySequence("Ctrl+0"), &look, &WindowLook::chooseUsualSize)
      ->setObjectName("usualSize");
  connect(&look, &WindowLook::changed, this, [&look, larger, smaller] {
    larger->setEnabled(look.canGrow());
    smaller->setEnabled(look.canShrink());
  });
}

void ViewMenu::addThemeMenu(WindowLook &look) {
  QMenu &menu = *addMenu(tr("Th&eme"));
  auto *group = new QActionGroup(this);
  for (const Theme &theme : themes()) {
    QString name = QString::fromStdString(theme.name);
    QAction *action = menu.addAction(themeTitle(name));
    action->setCheckable(true);
    action->setData(name);
    group->addAction(action);
    connect(action, &QAction::triggered, &look, [&look, name] { look.chooseTheme(name); });
  }
  connect(&menu, &QMenu::aboutToShow, this, [&look, group] {
    for (QAction *action : group->actions())
      action->setChecked(action->data().toString().toStdString() == look.theme().name);
  });
}

void ViewMenu::addPartsMenu(DrawnFigure &drawn) {
  QMenu &menu = *addMenu(tr("&Parts of the Picture"));
  menu.setObjectName("parts");
  for (const auto &[name, part] : shownPartNames) {
    QAction *action = menu.addAction(partTitle(part));
    action->setObjectName(QString::fromUtf8(name.data(), static_cast<int>(name.size())));
    action->setCheckable(true);
    action->setChecked(drawn.shownParts().*part);
    connect(action, &QAction::toggled, &drawn, [&drawn, part = part](bool on) {
      ShownParts shown = drawn.shownParts();
      shown.*part = on;
      drawn.setShownParts(shown);
    });
  }
}

} // namespace halfspace
