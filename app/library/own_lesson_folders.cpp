#include "app/library/own_lesson_folders.h"

#include "app/lessons_folder.h"
#include "app/work/learner_progress.h"

#include <QFileDialog>
#include <QMenu>

#include <utility>

namespace halfspace {

OwnLessonFolders::OwnLessonFolders(SessionModel &model, LearnerProgress &progress, Messages messages,
                                   QObject *parent)
    : QObject(parent), m_model(model), m_progress(progress), m_messages(messages) {}

void OwnLessonFolders::askAndAdd() {
  const QString folder = QFileDialog::getExistingDirectory(
      &m_messages.window(), tr("Folder of your own lessons"), m_folders.value(m_folders.size() - 1));
  if (!folder.isEmpty())
    add(folder);
}

void OwnLessonFolders::add(const QString &folder) {
  if (m_folders.contains(folder))
    return m_messages.say(tr("The lessons of %1 are there already.").arg(folder));
  LessonLibrary library = m_model.library();
  library.problems.clear();
  addOwnLessons(library, folder.toStdString());
  const QString problem =
      library.problems.empty() ? QString() : QString::fromStdString(library.problems.front().text());
  m_folders << folder;
  m_progress.nameSteps(library.lessons);
  m_model.setLibrary(std::move(library));
  m_messages.say(problem.isEmpty() ? tr("The lessons of %1 stand at the end of the contents.").arg(folder)
                                   : problem);
}

void OwnLessonFolders::remove(const QString &folder) {
  LessonLibrary library = m_model.library();
  std::erase_if(library.lessons, [&](const Lesson &lesson) {
    return areOneFolder(std::filesystem::path(lesson.file).parent_path(), folder.toStdString());
  });
  m_folders.removeAll(folder);
  m_model.setLibrary(std::move(library));
  m_messages.say(tr("The lessons of %1 are not in the contents any more. Their files stay.").arg(folder));
}

void OwnLessonFolders::fillMenu(QMenu &menu) {
  menu.clear();
  menu.addAction(tr("&Add a Folder…"), this, &OwnLessonFolders::askAndAdd);
  if (m_folders.isEmpty())
    return;
  menu.addSeparator();
  for (const QString &folder : m_folders)
    menu.addAction(tr("Remove %1").arg(QString(folder).replace("&", "&&")), this,
                   [this, folder] { remove(folder); });
}

} // namespace halfspace
