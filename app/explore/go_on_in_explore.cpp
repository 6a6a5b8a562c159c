#include "app/explore/go_on_in_explore.h"

#include "app/work/session_files.h"

#include <QCoreApplication>

namespace halfspace {
namespace {

struct GoOnInExplore {
  Q_DECLARE_TR_FUNCTIONS(halfspace::GoOnInExplore)
};

} // namespace

void goOnInExplore(SessionModel &model, SessionFiles &files, const Scene &scene) {
  const Lesson &lesson = model.lesson();
  const QString title = QString::fromStdString(lesson.title);
  const auto view = model.session().view;
  const Scene taken = scene; // the session that it may be of goes
  model.openLesson(exploreId);
  model.history().replaceScene(taken, GoOnInExplore::tr("Go on with “%1”").arg(title));
  if (view)
    model.history().setView(view);
  files.forgetFile();
}

} // namespace halfspace
