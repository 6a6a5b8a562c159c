#include "app/explore/go_on_in_explore.h"

#include <QCoreApplication>

namespace halfspace {

void goOnInExplore(SessionModel &model, const Scene &scene) {
  const Lesson &lesson = model.lesson();
  const QString title = QString::fromStdString(lesson.title);
  const auto view = model.session().view;
  const Scene taken = scene; // the session that it may be of goes
  model.openLesson(exploreId);
  model.history().replaceScene(
      taken, QCoreApplication::translate("halfspace::SceneMenu", "Go on with “%1”").arg(title));
  if (view)
    model.history().setView(view);
}

} // namespace halfspace
