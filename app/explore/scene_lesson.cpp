#include "app/explore/scene_lesson.h"

#include "app/explore/lesson_dialog.h"
#include "app/library/own_lesson_folders.h"
#include "app/work/save_dialog.h"
#include "app/work/session_files.h"
#include "lessons/files/write_file.h"
#include "lessons/lesson/draft_of_lesson.h"
#include "lessons/scene/file/large_meshes.h"

#include <QCheckBox>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// An id is no longer, and what is put behind it has room.
constexpr int longestId = 48;

/// What a title looks like as an id: `Wie weit? Für Ältere` is wie-weit-fur-altere.
QString idFrom(const QString &title) {
  QString id;
  for (const QChar sign : title.normalized(QString::NormalizationForm_D).toLower()) {
    const bool isIdSign = (sign >= 'a' && sign <= 'z') || (sign >= '0' && sign <= '9');
    if (isIdSign)
      id += sign;
    else if (!sign.isMark() && !id.isEmpty() && !id.endsWith('-'))
      id += '-';
  }
  id.truncate(longestId);
  while (id.endsWith('-'))
    id.chop(1);
  return id.isEmpty() ? QStringLiteral("lesson") : id;
}

/// Where the scene is looked at from.
CameraView viewOf(const SessionModel &model) {
  const auto &chosen = model.session().view;
  return chosen ? chosen->view : model.lesson().camera;
}

/// The constructions whose working is shown now.
std::vector<std::string> workingsShown(const SessionModel &model) {
  std::vector<std::string> names;
  for (const WorkingLine &line : model.shown().working.lines)
    if (const std::string entry = entryOf(line.id); names.empty() || names.back() != entry)
      names.push_back(entry);
  return names;
}

void keepThere(std::vector<std::string> &names, const Scene &scene) {
  std::erase_if(names, [&](const std::string &name) { return !scene.entries.find(name); });
}

/// A lesson as its file has it; nothing where a draft does not say all of it.
std::optional<LessonWork> workInFile(const Lesson &lesson) {
  auto draft = draftOf(lesson);
  const auto path = absolutePathOf(lesson.file);
  if (!draft || !path)
    return {};
  return LessonWork{std::move(*draft), {*path, lesson.text, lesson.id}, true};
}

/// What of a scene lessons have no place for.
QString leftOutOf(const Scene &scene) {
  QStringList sentences;
  if (!scene.labels.empty())
    sentences << SceneLesson::tr("Labels that you have moved or hidden are where they usually are in the "
                                 "lesson.");
  QStringList meshes;
  for (const std::string &name : largeMeshes(scene))
    meshes << QString::fromStdString(name);
  if (!meshes.isEmpty())
    sentences << SceneLesson::tr("The lesson is without %1, too large a mesh.").arg(meshes.join(", "));
  return sentences.join(" ");
}

} // namespace

SceneLesson::SceneLesson(SessionModel &model, SessionFiles &files, OwnLessonFolders &folders,
                         Messages messages, QObject *parent)
    : QObject(parent), m_model(model), m_files(files), m_folders(folders), m_messages(messages),
      m_item(this) {
  m_item.setObjectName("saveAsLesson");
  connect(&m_item, &QAction::triggered, this, &SceneLesson::edit);
  connect(&model, &SessionModel::lessonChanged, this, &SceneLesson::enable);
  connect(&files, &SessionFiles::changed, this, &SceneLesson::enable); // what was written may be back
  connect(&model, &SessionModel::outcomeChanged, this, [this] {
    if (isExplore(m_model))
      enable();
  });
  enable();
}

void SceneLesson::enable() {
  const bool isThere = isExplore(m_model);
  m_item.setText(isThere ? tr("Save as &Lesson…") : tr("Edit &Lesson…"));
  m_item.setEnabled(isThere ? !m_model.session().scene.entries.empty()
                            : workOn(m_model.lesson()).has_value());
}

std::optional<LessonWork> SceneLesson::workOn(const Lesson &lesson) const {
  if (!m_model.library().find(lesson.id))
    return {}; // its file is not known
  const LessonWorks &works = m_files.lessonWorks();
  const auto left = works.find(lesson.id);
  return left == works.end() ? workInFile(lesson) : left->second;
}

LessonWork SceneLesson::workInExplore() const {
  const LessonWorks &works = m_files.lessonWorks();
  const auto left = works.find(exploreId);
  LessonWork work = left == works.end() ? LessonWork{{}, {}, true} : left->second;
  if (const Lesson *saved = work.isSaved ? m_model.library().find(work.file.lesson) : nullptr)
    work = workInFile(*saved).value_or(work); // it may have been edited where it is open
  LessonDraft &draft = work.draft;
  if (draft.steps.empty())
    draft.steps.push_back({tr("Step %1").arg(1).toStdString(), "", workingsShown(m_model)});
  for (DraftStep &step : draft.steps) {
    keepThere(step.workings, m_model.session().scene);
    keepThere(step.hidden, m_model.session().scene);
  }
  return work;
}

void SceneLesson::keep(const std::string &lesson, const std::optional<LessonWork> &work) {
  LessonWorks works = m_files.lessonWorks();
  if (work && (lesson == exploreId || !work->isSaved))
    works[lesson] = *work;
  else
    works.erase(lesson);
  m_files.setLessonWorks(std::move(works));
}

void SceneLesson::goOnWith(const Lesson &lesson) {
  const LessonWorks &works = m_files.lessonWorks();
  const auto there = works.find(exploreId);
  if (there == works.end() || there->second.isSaved)
    keep(exploreId, workOn(lesson));
}

void SceneLesson::edit() {
  if (isExplore(m_model)) {
    LessonWork work = workInExplore();
    if (write(exploreId, work, {m_model.evaluation(), viewOf(m_model)}))
      offerToOpen(work.file);
  } else if (auto work = workOn(m_model.lesson())) {
    const Lesson &lesson = m_model.lesson();
    const std::string id = lesson.id;
    if (write(id, *work, {evaluate(lesson.scene), lesson.camera, m_model.session().step}))
      m_messages.say(tr("The lesson is saved."));
  }
}

bool SceneLesson::write(const std::string &lesson, LessonWork &work, const Start &start) {
  const auto check = [&](const LessonDraft &draft) {
    return checkedIn(work.file.path, draft, work, start).problems;
  };
  LessonDialog dialog(work.draft, start.scene, leftOutOf(start.scene.scene), check, &m_messages.window());
  dialog.showStep(start.step);
  if (lesson != exploreId)
    dialog.setEditing();
  const LessonWork before = work;
  connect(&dialog, &LessonDialog::written, this, [&] {
    work.draft = dialog.draft();
    work.isSaved = before.isSaved && tidied(work.draft) == tidied(before.draft);
    keep(lesson, work);
  });
  connect(&dialog, &LessonDialog::discardWanted, this, [&] {
    if (!askAbove(dialog, tr("Discard what is written here and not saved?"), QMessageBox::Discard))
      return;
    keep(lesson, {});
    dialog.reject();
  });
  connect(&dialog, &LessonDialog::saveWanted, this, [&] {
    if (save(dialog, work, start))
      dialog.accept();
  });
  const bool isSaved = dialog.exec() == QDialog::Accepted;
  if (isSaved)
    keep(lesson, work);
  else if (!work.isSaved && m_files.lessonWorks().contains(lesson))
    m_messages.say(tr("What you have written is kept: %1 in the File menu goes on with it.")
                       .arg(m_item.text().remove('&').remove(QStringLiteral("…"))));
  return isSaved;
}

CheckedDraft SceneLesson::checkedIn(const QString &file, LessonDraft draft, const LessonWork &work,
                                    const Start &start) const {
  const bool isThere = !file.isEmpty() && file == work.file.path;
  draft.id = isThere ? work.file.lesson : freshId(draft.title);
  return checked(draft, start.scene, start.camera, file.toStdString()); // with the pictures there
}

QString SceneLesson::askForFile(LessonDialog &dialog, const LessonWork &work) const {
  const bool isNew = work.file.path.isEmpty();
  const QFileInfo before(work.file.path);
  return askWhereToSave(
      dialog, tr("Save as lesson"), tr("Lessons (*.md)"),
      isNew ? idFrom(QString::fromStdString(dialog.draft().title)) : before.completeBaseName(), "md",
      isNew ? m_folders.folders().value(m_folders.folders().size() - 1) : before.path());
}

bool SceneLesson::save(LessonDialog &dialog, LessonWork &work, const Start &start) {
  // Made in Explore it may be another lesson.
  const bool isAsked = isExplore(m_model) || work.file.path.isEmpty();
  if (!isAsked && !mayReplace(work.file, work.file.text) &&
      !askAbove(dialog,
                tr("Another program has changed %1 since. Replace it with what is written here?")
                    .arg(QFileInfo(work.file.path).fileName()),
                QMessageBox::Yes))
    return false;
  const QString file = isAsked ? askForFile(dialog, work) : work.file.path;
  if (file.isEmpty())
    return false;
  const CheckedDraft lesson = checkedIn(file, dialog.draft(), work, start);
  const auto problem = lesson.problems.empty()
                           ? writeFile(file.toStdString(), lesson.text)
                           : std::optional(Problem{lesson.problems.front().sentence, "", 0, ""});
  if (problem) {
    dialog.complain(tr("The lesson is not saved. %1").arg(QString::fromStdString(problem->text())));
    return false;
  }
  Lesson written = *parseLesson(lesson.text, file.toStdString()); // it was checked
  work = {dialog.draft(), {file, lesson.text, written.id}, true};
  const auto left = m_model.leftSessions().find(written.id);
  if (left != m_model.leftSessions().end() && !areBuiltAlike(left->second.scene, written.scene))
    m_model.leftSessions().erase(left); // it is of another scene
  keep(written.id, {});
  LessonLibrary library = m_model.library();
  library.put(std::move(written));
  m_model.setLibrary(std::move(library));
  return true;
}

bool SceneLesson::askAbove(LessonDialog &dialog, const QString &question, QMessageBox::StandardButton goOn) {
  QMessageBox box(QMessageBox::Warning, tr("Halfspace"), question, goOn | QMessageBox::Cancel, &dialog);
  box.setTextFormat(Qt::PlainText);
  box.setDefaultButton(QMessageBox::Cancel);
  return box.exec() == goOn;
}

void SceneLesson::offerToOpen(const KnownFile &file) {
  const QString folder = QFileInfo(file.path).absolutePath();
  QMessageBox box(QMessageBox::Question, tr("Halfspace"), tr("The lesson is saved. Open it now?"),
                  QMessageBox::Open | QMessageBox::Close, &m_messages.window());
  QCheckBox always(tr("Show the lessons of its &folder in the contents from now on"));
  always.setChecked(true);
  if (!m_folders.folders().contains(folder))
    box.setCheckBox(&always);
  box.setDefaultButton(QMessageBox::Open);
  const bool isOpened = box.exec() == QMessageBox::Open;
  if (box.checkBox() && always.isChecked())
    m_folders.add(folder);
  if (isOpened)
    m_model.openLesson(file.lesson);
}

std::string SceneLesson::freshId(const std::string &title) const {
  const std::string wanted = idFrom(QString::fromStdString(title)).toStdString();
  std::string id = wanted;
  for (int number = 2; m_model.library().find(id); ++number)
    id = wanted + "-" + std::to_string(number);
  return id;
}

} // namespace halfspace
