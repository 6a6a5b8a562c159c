#include "app/work/leftover_work.h"

#include "app/panels/unfinished_input.h"
#include "app/work/autosave.h"
#include "app/work/session_files.h"
#include "lessons/scene/file/session_file.h"
#include "widgets/view/scene_drawing.h"

#include <QFileInfo>
#include <QLocale>
#include <QMenu>

#include <algorithm>
#include <chrono>
#include <memory>

namespace halfspace {
namespace {

/// Whoever lives so long after the first picture of a session has not ended for it.
constexpr std::chrono::milliseconds openedDelay{1500};

QString whenWritten(const Recovery::Leftover &leftover) {
  return QLocale().toString(leftover.written, QLocale::ShortFormat);
}

} // namespace

LeftoverWork::LeftoverWork(SessionModel &model, SessionFiles &files, Autosave &autosave,
                           UnfinishedInput &input, const SceneDrawing &drawing, Messages messages)
    : m_model(model), m_files(files), m_autosave(autosave), m_input(input), m_drawing(drawing),
      m_messages(messages) {
  m_openedTimer.setSingleShot(true);
  m_openedTimer.setInterval(openedDelay);
  connect(&m_openedTimer, &QTimer::timeout, this, [this] { m_autosave.recovery().opened(); });
}

void LeftoverWork::takeUp(const QString &path) {
  if (!m_input.finishOrAsk())
    return;
  // What is unsaved here becomes a leftover itself.
  if (const auto problem = m_autosave.keepNow())
    return m_messages.complain(QString::fromStdString(problem->text()));
  const auto work = m_autosave.recovery().adopt(path);
  if (!work)
    return m_messages.complain(tr("Another window has taken up this work already."));
  m_model.leftSessions() = work->left;
  m_files.startWith(work->session, work->file);
  if (work->lessons)
    m_files.setLessonWorks(*work->lessons);
  if (!work->file || work->file->text != writeSession(work->session))
    m_model.history().resetClean();
  const auto drawn = std::make_shared<QMetaObject::Connection>();
  *drawn = connect(&m_drawing, &SceneDrawing::frameDrawn, this, [this, drawn] {
    disconnect(*drawn);
    m_openedTimer.start();
  });
  m_messages.say(tr("Your unsaved work is back. Edit > Start Over begins the lesson anew."));
}

void LeftoverWork::offerAgain(const Recovery::Leftover &leftover) {
  const QString question = tr("The program ended while it was opening your unsaved work of %1. Open it "
                              "again? Else it stays in File > Unsaved Work.")
                               .arg(whenWritten(leftover));
  if (m_messages.ask(QMessageBox::Question, question, QMessageBox::Open | QMessageBox::Cancel,
                     QMessageBox::Cancel) == QMessageBox::Open)
    takeUp(leftover.path);
}

void LeftoverWork::restoreNewest() {
  const auto leftovers = m_autosave.recovery().leftovers();
  if (leftovers.empty())
    return;
  if (leftovers.front().endedItsProgram)
    offerAgain(leftovers.front());
  else
    takeUp(leftovers.front().path);
}

void LeftoverWork::offer() {
  const auto leftovers = m_autosave.recovery().leftovers();
  const auto &file = m_files.file();
  const auto ours =
      std::find_if(leftovers.begin(), leftovers.end(), [&file](const Recovery::Leftover &leftover) {
        return file && leftover.work.file && leftover.work.file->path == file->path;
      });
  if (ours != leftovers.end() &&
      m_messages.ask(QMessageBox::Question,
                     tr("There are unsaved changes to %1 from a run that was cut off. Go on with them?")
                         .arg(QFileInfo(file->path).fileName()),
                     QMessageBox::Yes | QMessageBox::No) == QMessageBox::Yes)
    return takeUp(ours->path);
  if (!leftovers.empty())
    m_messages.say(tr("Unsaved work from an earlier run waits in File > Unsaved Work."));
}

QString LeftoverWork::nameOf(const Recovery::Leftover &leftover) const {
  const UnsavedWork &work = leftover.work;
  if (work.file)
    return QFileInfo(work.file->path).fileName();
  const Lesson *lesson = m_model.library().find(work.session.lesson);
  return QString::fromStdString(lesson ? lesson->title : work.session.lesson);
}

void LeftoverWork::fillMenu(QMenu &menu) {
  menu.clear();
  for (const Recovery::Leftover &leftover : m_autosave.recovery().leftovers())
    menu.addAction(tr("%1 (%2)").arg(nameOf(leftover), whenWritten(leftover)), this,
                   [this, path = leftover.path] { takeUp(path); });
  if (menu.isEmpty())
    menu.addAction(tr("None"))->setEnabled(false);
}

} // namespace halfspace
