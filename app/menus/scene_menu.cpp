#include "app/menus/scene_menu.h"

#include "app/explore/field_presenter.h"
#include "app/explore/go_on_in_explore.h"
#include "app/menus/add_item.h"

namespace halfspace {

SceneMenu::SceneMenu(SessionModel &model, FieldPresenter &field, QWidget *parent)
    : QMenu(tr("S&cene"), parent), m_model(model) {
  addItem(*this, tr("&Type or Find…"), QKeySequence("Ctrl+K"), &field, &FieldPresenter::open)
      ->setObjectName("typeOrFind");
  m_goOn = addItem(*this, tr("&Go on in Explore"), QKeySequence("Ctrl+Shift+K"), this,
                   [this] { goOnInExplore(m_model, m_model.session().scene); });
  m_goOn->setObjectName("goOnInExplore");
  const auto show = [this] { m_goOn->setEnabled(!isExplore(m_model)); };
  connect(&model, &SessionModel::lessonChanged, this, show);
  show();
}

} // namespace halfspace
