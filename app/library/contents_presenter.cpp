#include "app/library/contents_presenter.h"

#include "app/work/learner_progress.h"
#include "widgets/lesson/contents_drawer.h"

namespace halfspace {

ContentsPresenter::ContentsPresenter(SessionModel &model, ContentsDrawer &drawer,
                                     const LearnerProgress &progress, QObject *parent)
    : QObject(parent), m_model(model), m_drawer(drawer), m_progress(progress) {
  connect(&drawer, &ContentsDrawer::lessonChosen, this,
          [this](const QString &id) { m_model.openLesson(id.toStdString()); });
  connect(&model, &SessionModel::lessonChanged, &drawer, &ContentsDrawer::close);
}

void ContentsPresenter::show() {
  std::vector<ContentsDrawer::Entry> entries;
  for (const Lesson &lesson : m_model.library().lessons)
    entries.push_back({QString::fromStdString(lesson.id), QString::fromStdString(lesson.title),
                       m_progress.stateOf(lesson), QString::fromStdString(lesson.chapter),
                       m_progress.idsStillNeeded(lesson)});
  m_drawer.setLessons(entries, QString::fromStdString(m_model.session().lesson));
  m_drawer.open();
}

} // namespace halfspace
