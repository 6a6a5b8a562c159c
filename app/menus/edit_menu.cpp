#include "app/menus/edit_menu.h"

#include "app/export/figure_export.h"
#include "app/export/scene_paste.h"
#include "app/menus/add_item.h"
#include "app/step/fresh_start.h"
#include "app/work/scene_meshes.h"
#include "app/work/working_copy.h"
#include "widgets/session_model.h"
#include "widgets/view/scene_view.h"

#include <QActionGroup>

#include <functional>

namespace halfspace {
namespace {

/// An item for a step back or forth: it says what that does, and can be chosen where there is one.
QAction *addHistoryItem(QMenu &menu, const QString &name, const QString &nameOfWhat, SessionHistory &history,
                        void (SessionHistory::*step)(),
                        const std::function<std::optional<std::string>()> &textOfStep) {
  QAction *item = menu.addAction(name);
  QObject::connect(item, &QAction::triggered, &history, step);
  const auto follow = [item, name, nameOfWhat, textOfStep] {
    const auto what = textOfStep();
    item->setEnabled(what.has_value());
    item->setText(what ? nameOfWhat.arg(QString::fromStdString(*what)) : name);
  };
  QObject::connect(&history, &SessionHistory::stepsChanged, item, follow);
  follow();
  return item;
}

} // namespace

EditMenu::EditMenu(SessionModel &model, SceneView &scene, SceneMeshes &meshes, FreshStart &freshStart,
                   const WorkingCopy &working, FigureExport &figures, ScenePaste &paste, QWidget *parent)
    : QMenu(tr("&Edit"), parent) {
  addHistory(model.history());
  addSeparator();
  addItem(*this, tr("&Start Over"), QKeySequence("Ctrl+R"), this, [&freshStart] { freshStart.startOver(); });
  addItem(*this, tr("&Copy Picture"), QKeySequence("Ctrl+Shift+C"), &figures, &FigureExport::copy);
  addCopyMenu(working);
  addItem(*this, tr("&Paste Scene"), QKeySequence::Paste, &paste, &ScenePaste::paste);
  addCornerItems(scene);
  addMeshItems(meshes, scene.handles());
  addSnapMenu(model.snapping());
}

void EditMenu::addHistory(SessionHistory &history) {
  addHistoryItem(*this, tr("&Undo"), tr("&Undo %1"), history, &SessionHistory::undo, [&history] {
    return history.undoText();
  })->setShortcut(QKeySequence::Undo);
  addHistoryItem(*this, tr("&Redo"), tr("&Redo %1"), history, &SessionHistory::redo, [&history] {
    return history.redoText();
  })->setShortcuts({QKeySequence::Redo, QKeySequence("Ctrl+Y")});
}

void EditMenu::addCopyMenu(const WorkingCopy &working) {
  QMenu &menu = *addMenu(tr("Copy &Working As"));
  menu.setObjectName("copyWorking");
  const auto add = [&](const QString &name, DocumentFormat format) {
    addItem(menu, name, {}, this, [&working, format] { working.copy(format); });
  };
  add(tr("&LaTeX"), DocumentFormat::Latex);
  add(tr("&MathML"), DocumentFormat::MathMl);
  add(tr("&Plain Text"), DocumentFormat::PlainText);
  connect(this, &QMenu::aboutToShow, &menu, [&menu, &working] { menu.setEnabled(working.canCopy()); });
}

void EditMenu::addCornerItems(SceneView &scene) {
  HandleEdits &edits = scene.edits();
  QAction *add = addItem(*this, tr("&Add a Corner Here"), Qt::Key_Insert, &edits, &HandleEdits::addCorner);
  QAction *remove =
      addItem(*this, tr("Re&move the Corner"), QKeySequence::Delete, &edits, &HandleEdits::removeCorner);
  const auto enable = [&edits, add, remove] {
    add->setEnabled(edits.isCornerSelected());
    remove->setEnabled(edits.isCornerSelected());
  };
  connect(&scene.handles(), &SceneHandles::selectionChanged, this, enable);
  enable();
}

void EditMenu::addMeshItems(SceneMeshes &meshes, const SceneHandles &handles) {
  QAction *copy =
      addItem(*this, tr("A&nother Such Mesh"), QKeySequence("Ctrl+D"), &meshes, &SceneMeshes::copySelected);
  QAction *remove =
      addItem(*this, tr("Remo&ve the Mesh"), QKeySequence::Delete, &meshes, &SceneMeshes::removeSelected);
  const auto enable = [&meshes, copy, remove] {
    copy->setEnabled(meshes.canCopySelected());
    remove->setEnabled(meshes.canRemoveSelected());
  };
  connect(&handles, &SceneHandles::selectionChanged, this, enable);
  enable();
}

void EditMenu::addSnapMenu(Snapping &snapping) {
  QMenu &menu = *addMenu(tr("S&nap To"));
  menu.setObjectName("snap");
  auto *group = new QActionGroup(this);
  const auto addChoice = [&menu, group](const QString &text) {
    QAction *action = menu.addAction(text);
    action->setCheckable(true);
    group->addAction(action);
    return action;
  };
  const std::pair<QString, Rational> steps[] = {{tr("Whole numbers"), 1},
                                                {tr("Halves"), Rational(1, 2)},
                                                {tr("Quarters"), Rational(1, 4)},
                                                {tr("Tenths"), Rational(1, 10)}};
  for (const auto &[text, step] : steps) {
    QAction *action = addChoice(text);
    connect(&menu, &QMenu::aboutToShow, action,
            [&snapping, action, step = step] { action->setChecked(snapping.isOn && step == snapping.step); });
    connect(action, &QAction::triggered, this, [&snapping, step = step] { snapping = {step, true}; });
  }
  QAction *nothing = addChoice(tr("Nothing (thousandths)"));
  connect(nothing, &QAction::triggered, this, [&snapping] { snapping.isOn = false; });
  connect(&menu, &QMenu::aboutToShow, nothing, [&snapping, nothing] { nothing->setChecked(!snapping.isOn); });
  menu.addSeparator();
  menu.addAction(tr("Hold Ctrl while dragging for thousandths"))->setEnabled(false);
}

} // namespace halfspace
