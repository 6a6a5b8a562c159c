#include "app/explore/go_on_in_explore.h"

#include "app/work/session_files.h"

namespace halfspace {

GoOnInExplore::GoOnInExplore(SessionModel &model, SessionFiles &files, QObject *parent)
    : QObject(parent), m_model(model), m_files(files) {}

void GoOnInExplore::with(const Scene &scene) {
  emit begun(m_model.lesson());
  const QString title = QString::fromStdString(m_model.lesson().title);
  const auto view = m_model.session().view;
  const Scene taken = scene; // the session that it may be of goes
  m_model.openLesson(exploreId);
  m_model.history().replaceScene(taken, tr("Go on with “%1”").arg(title));
  if (view)
    m_model.history().setView(view);
  m_files.forgetFile();
}

} // namespace halfspace
