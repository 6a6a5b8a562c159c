#include "app/work/session_files.h"

#include "app/open_session.h"
#include "app/panels/unfinished_input.h"
#include "app/work/save_dialog.h"
#include "lessons/files/write_file.h"
#include "lessons/lesson/explore.h"
#include "lessons/lesson/lesson_start.h"
#include "lessons/scene/file/large_meshes.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/file/shape_text.h"
#include "widgets/carriers/carrier.h"
#include "widgets/text/figures.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>

#include <utility>

namespace halfspace {
namespace {

/// What is told of a scene that is saved.
QString savedWords(const Scene &scene) {
  QStringList left;
  for (const std::string &name : largeMeshes(scene))
    left << QString::fromStdString(name);
  if (left.isEmpty())
    return SessionFiles::tr("Saved.");
  return SessionFiles::tr(
             "Saved, but without %1: a mesh of more than %2 triangles is not kept in a session. Open "
             "its own file again to go on with it.")
      .arg(left.join(", "), counted(mostWrittenTriangles));
}

} // namespace

SessionFiles::SessionFiles(SessionModel &model, UnfinishedInput &input, Messages messages,
                           std::shared_ptr<const KnownFile> file)
    : m_model(model), m_input(input), m_messages(messages), m_file(std::move(file)) {}

void SessionFiles::startWith(const Session &session, std::shared_ptr<const KnownFile> file) {
  m_file = std::move(file);
  dropLesson(session);
  m_model.startWith(session);
  emit changed();
}

void SessionFiles::startNew() {
  const std::string before = m_model.session().lesson;
  m_model.openLesson(exploreId); // what waits there is asked about; a lesson stays as it is
  if (mayLeave())
    startWith(startOf(exploreLesson()));
  else
    m_model.openLesson(before);
}

void SessionFiles::open(const QString &file) {
  LessonLibrary library = m_model.library();
  auto opened = openSession(library, file.toStdString());
  if (!opened)
    return m_messages.complain(QString::fromStdString(opened.problem().text()));
  std::shared_ptr<const KnownFile> known;
  if (opened->origin == OpenedSession::Origin::SessionFile)
    known = std::make_shared<KnownFile>(
        KnownFile{QFileInfo(file).absoluteFilePath(), std::move(opened->text), opened->session.lesson});
  m_file = std::move(known);
  dropLesson(opened->session);
  if (opened->origin == OpenedSession::Origin::Lesson)
    m_model.startWith(std::move(opened->session), std::move(library)); // with the lesson
  else
    m_model.startWith(std::move(opened->session));
  emit changed();
}

void SessionFiles::askAndOpen() {
  if (!mayLeave())
    return;
  QString pictures;
  for (const std::string &ending : pictureEndings())
    pictures += " *" + QString::fromStdString(ending);
  const QString file = QFileDialog::getOpenFileName(
      &m_messages.window(), tr("Open"), {},
      tr("Sessions, pictures and lessons (%1)").arg("*.halfspace *.md" + pictures));
  if (!file.isEmpty())
    open(file);
}

bool SessionFiles::finishInput() {
  const QString refused = m_input.finish();
  if (!refused.isEmpty())
    m_messages.complain(tr("The session is not saved.") + "\n" + refused);
  return refused.isEmpty();
}

bool SessionFiles::save() {
  if (!finishInput())
    return false;
  if (!belongsToFile())
    return saveAs();
  return mayReplace(*m_file, writeSession(m_model.session())) ? saveTo(QString(m_file->path))
                                                              : askToReplace(*m_file);
}

bool SessionFiles::saveAs() {
  if (!finishInput())
    return false;
  const QString file =
      askWhereToSave(m_messages.window(), tr("Save session"), tr("Halfspace sessions (*.halfspace)"),
                     QString::fromStdString(m_model.session().lesson), "halfspace");
  return !file.isEmpty() && saveTo(file);
}

bool SessionFiles::saveTo(const QString &file) {
  const std::string text = writeSession(m_model.session());
  if (const auto problem = writeFile(file.toStdString(), text)) {
    m_messages.complain(tr("The session is not saved.") + "\n" + QString::fromStdString(problem->text()));
    return false;
  }
  m_file = std::make_shared<KnownFile>(
      KnownFile{QFileInfo(file).absoluteFilePath(), text, m_model.session().lesson});
  m_model.history().setClean();
  emit changed();
  m_messages.say(savedWords(m_model.session().scene));
  return true;
}

void SessionFiles::forgetFile() {
  m_file = {};
  emit changed();
}

QString SessionFiles::name() const {
  return m_file ? QFileInfo(m_file->path).fileName() : QString::fromStdString(m_model.lesson().title);
}

bool SessionFiles::belongsToFile() const { return m_file && m_model.session().lesson == m_file->lesson; }

bool SessionFiles::hasChanges() const {
  // After another lesson was opened the history is not clean, though nothing need have changed.
  return !m_model.history().isClean() && (belongsToFile() || isChanged(m_model));
}

void SessionFiles::setLessonWorks(LessonWorks works) {
  if (works == *m_works)
    return;
  m_works = std::make_shared<const LessonWorks>(std::move(works));
  emit changed();
}

void SessionFiles::dropLesson(const Session &coming) {
  const auto there = m_works->find(exploreId);
  if (there == m_works->end())
    return;
  const bool isReplaced = coming.lesson == exploreId && there->second.isSaved;
  if (isExplore(m_model) || isReplaced) {
    LessonWorks others = *m_works;
    others.erase(exploreId);
    m_works = std::make_shared<const LessonWorks>(std::move(others));
  }
}

bool SessionFiles::mayLeave() {
  return m_input.finishOrAsk() && (!hasChanges() || askToKeepChanges()) && askToDropLesson();
}

bool SessionFiles::mayClose() {
  if (!m_input.finishOrAsk())
    return false;
  if (!hasChanges() || !belongsToFile())
    return true;
  if (!askToKeepChanges())
    return false;
  if (hasChanges())
    dropChanges();
  return true;
}

bool SessionFiles::askToKeepChanges() {
  const auto answer =
      m_messages.ask(QMessageBox::Question, tr("Save your changes to “%1” first?").arg(name()),
                     QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool SessionFiles::askToDropLesson() {
  const auto work = isExplore(m_model) ? m_works->find(exploreId) : m_works->end();
  if (work == m_works->end() || work->second.isSaved)
    return true;
  const QString title = QString::fromStdString(work->second.draft.title).trimmed();
  return m_messages.ask(
             QMessageBox::Warning,
             title.isEmpty()
                 ? tr("What you have written of a lesson of this scene is not saved.")
                 : tr("The lesson “%1” that you have written of this scene is not saved.").arg(title),
             QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel) == QMessageBox::Discard;
}

bool SessionFiles::askToReplace(const KnownFile &file) {
  QMessageBox box(
      QMessageBox::Warning, tr("Halfspace"),
      tr("Another window or program has changed %1 since you opened it. Replace it with what you see here?")
          .arg(QFileInfo(file.path).fileName()),
      QMessageBox::Cancel, &m_messages.window());
  box.setTextFormat(Qt::PlainText);
  const QPushButton *replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
  QPushButton *elsewhere = box.addButton(tr("Save &As…"), QMessageBox::AcceptRole);
  box.setDefaultButton(elsewhere);
  box.exec();
  if (box.clickedButton() == replace)
    return saveTo(QString(file.path)); // saving changes what is known of the file
  return box.clickedButton() == elsewhere && saveAs();
}

void SessionFiles::dropChanges() {
  if (const auto saved = readSession(m_file->text, m_file->path.toStdString()))
    m_model.startWith(*saved); // a lesson that is written stays: nobody asked about it
}

} // namespace halfspace
