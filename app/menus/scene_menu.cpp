#include "app/menus/scene_menu.h"

#include "app/explore/field_presenter.h"
#include "app/explore/go_on_in_explore.h"
#include "app/menus/add_item.h"
#include "app/work/scene_meshes.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/scene/fresh_names.h"
#include "widgets/view/object_hand.h"
#include "widgets/view/object_tool_words.h"

namespace halfspace {

SceneMenu::SceneMenu(SessionModel &model, GoOnInExplore &goOn, FieldPresenter &field, ObjectHand &hand,
                     SceneMeshes &meshes, QWidget *parent)
    : QMenu(tr("S&cene"), parent), m_model(model) {
  addItem(*this, tr("&Type or Find…"), QKeySequence("Ctrl+K"), &field, &FieldPresenter::open)
      ->setObjectName("typeOrFind");
  m_goOn = addItem(*this, tr("&Go on in Explore"), QKeySequence("Ctrl+Shift+K"), this,
                   [this, &goOn] { goOn.with(m_model.session().scene); });
  m_goOn->setObjectName("goOnInExplore");
  addTools(hand);
  addLines(field);
  addItem(*m_add, tr("&Mesh…"), {}, &meshes, &SceneMeshes::askAndOpen)->setObjectName("add-mesh");
  const auto show = [this] {
    m_goOn->setEnabled(!isExplore(m_model));
    m_add->setEnabled(isExplore(m_model));
  };
  connect(&model, &SessionModel::lessonChanged, this, show);
  show();
}

void SceneMenu::addTools(ObjectHand &hand) {
  m_add = addMenu(tr("&Add"));
  m_add->setObjectName("add");
  m_add->setToolTipsVisible(true);
  for (const ObjectToolWords &tool : objectTools()) {
    QAction *action = m_add->addAction(tool.title);
    action->setObjectName("add-" + tool.id);
    action->setToolTip(tool.description);
    connect(action, &QAction::triggered, &hand, [&hand, object = tool.object] { hand.begin(object); });
  }
  m_add->addSeparator();
}

void SceneMenu::addLines(FieldPresenter &field) {
  const auto add = [this, &field](const QString &title, std::string_view kind, const QString &line) {
    addItem(*m_add, title, {}, &field, [this, &field, kind, line] {
      const std::string name = FreshNames(m_model.session().scene).ofKind(*findKind(kind));
      field.propose(line.arg(QString::fromStdString(name)));
    });
  };
  add(tr("&Number…"), NumberObject::kind, "%1 = 1, 0 <= %1 <= 5, step 1/2");
  add(tr("Plane by its &equation…"), PlaneObject::kind, "%1: x + 2y + 2z = 9");
}

} // namespace halfspace
