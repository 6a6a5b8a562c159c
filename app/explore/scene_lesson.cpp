#include "app/explore/scene_lesson.h"

#include "app/explore/checked_draft.h"
#include "app/explore/lesson_dialog.h"
#include "app/work/save_dialog.h"
#include "app/work/session_files.h"
#include "lessons/files/write_file.h"
#include "lessons/scene/file/large_meshes.h"

#include <QFileInfo>

#include <algorithm>

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

SceneLesson::SceneLesson(SessionModel &model, SessionFiles &files, Messages messages, QObject *parent)
    : QObject(parent), m_model(model), m_files(files), m_messages(messages),
      m_item(tr("Save as &Lesson…"), this) {
  m_item.setObjectName("saveAsLesson");
  connect(&m_item, &QAction::triggered, this, &SceneLesson::edit);
  const auto enable = [this] {
    m_item.setEnabled(isExplore(m_model) && !m_model.session().scene.entries.empty());
  };
  connect(&model, &SessionModel::outcomeChanged, this, enable);
  enable();
}

void SceneLesson::edit() {
  const Evaluation start = m_model.evaluation();
  const auto check = [&](const LessonDraft &draft) {
    return checked(withId(draft), start.scene, viewOf(m_model), m_file.toStdString()).problems;
  };
  LessonDialog dialog(begun(), start, leftOutOf(start.scene), check, &m_messages.window());
  connect(&dialog, &LessonDialog::saveWanted, this, [&] {
    if (save(dialog))
      dialog.accept();
  });
  const bool isSaved = dialog.exec() == QDialog::Accepted;
  m_draft = dialog.draft();
  if (isSaved)
    offerToOpen();
}

LessonDraft SceneLesson::begun() const {
  LessonDraft draft = m_draft;
  if (draft.steps.empty())
    draft.steps.push_back({tr("Step %1").arg(1).toStdString(), "", workingsShown(m_model)});
  for (DraftStep &step : draft.steps) {
    keepThere(step.workings, m_model.session().scene);
    keepThere(step.hidden, m_model.session().scene);
  }
  return draft;
}

LessonDraft SceneLesson::withId(LessonDraft draft) const {
  const std::string id = idFrom(QString::fromStdString(draft.title)).toStdString();
  const auto isTaken = [&](const std::string &name) {
    return m_model.library().find(name) && !m_ours.contains(name);
  };
  draft.id = id;
  for (int number = 2; isTaken(draft.id); ++number)
    draft.id = id + "-" + std::to_string(number);
  return draft;
}

bool SceneLesson::save(LessonDialog &dialog) {
  const LessonDraft draft = withId(dialog.draft());
  const QString file =
      askWhereToSave(dialog, tr("Save as lesson"), tr("Lessons (*.md)"), QString::fromStdString(draft.id),
                     "md", m_file.isEmpty() ? QString() : QFileInfo(m_file).path());
  if (file.isEmpty())
    return false;
  const CheckedDraft lesson =
      checked(draft, m_model.session().scene, viewOf(m_model), file.toStdString()); // with the pictures there
  const auto problem = lesson.problems.empty()
                           ? writeFile(file.toStdString(), lesson.text)
                           : std::optional(Problem{lesson.problems.front().sentence, "", 0, ""});
  if (problem) {
    dialog.complain(tr("The lesson is not saved. %1").arg(QString::fromStdString(problem->text())));
    return false;
  }
  m_file = file;
  m_ours.insert(draft.id);
  return true;
}

void SceneLesson::offerToOpen() {
  const auto answer = m_messages.ask(QMessageBox::Question, tr("The lesson is saved. Open it now?"),
                                     QMessageBox::Open | QMessageBox::Close, QMessageBox::Open);
  if (answer == QMessageBox::Open && m_files.mayLeave())
    m_files.open(m_file);
}

} // namespace halfspace
