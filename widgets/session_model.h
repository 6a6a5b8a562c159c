// The session that the window works on, with what it comes to.
#pragma once

#include "lessons/lesson/explore.h"
#include "lessons/lesson/shown.h"
#include "lessons/scene/hand/snap_targets.h"
#include "lessons/scene/hand/snapping.h"
#include "widgets/session_history.h"
#include "widgets/shown_scene.h"

#include <functional>
#include <map>

namespace halfspace {

/// How what is moved by the hand snaps.
struct Snapping {
  Rational step = 1; ///< in which handles move when dragged or stepped by keys, in units of the stage
  bool isOn = true;  ///< whether what is dragged snaps; keys go in steps all the same

  /// The step of a drag: the finest while keys suspend snapping.
  [[nodiscard]] const Rational &dragStep(bool isSuspended) const {
    return isOn && !isSuspended ? step : finestStep;
  }
};

/// Owns the window's one session. Views are written from `evaluation()` and send edits back to its history;
/// they hold no truth.
class SessionModel : public QObject {
  Q_OBJECT

public:
  /// Begins with a session; see startWith.
  SessionModel(LessonLibrary library, Session first);
  /// Begins with the first lesson. Requires at least one.
  explicit SessionModel(const LessonLibrary &library);

  [[nodiscard]] const LessonLibrary &library() const { return m_library; }
  [[nodiscard]] const Session &session() const { return m_history.session(); }
  [[nodiscard]] const Lesson &lesson() const { return *m_lesson; }
  /// What the scene comes to.
  [[nodiscard]] const Evaluation &evaluation() const { return m_scene.evaluation(); }
  /// All of its marks.
  [[nodiscard]] const Figure &figure() const { return m_scene.figure(); }
  /// The current step; of a lesson that is not in the library, one that shows everything.
  [[nodiscard]] const LessonStep &step() const;
  /// What the current step shows of the scene.
  [[nodiscard]] const Shown &shown() const { return m_scene.shown(); }
  /// What was done to the session, and the gesture that goes on: all edits go there.
  [[nodiscard]] SessionHistory &history() { return m_history; }
  [[nodiscard]] const SessionHistory &history() const { return m_history; }
  /// The stage that the scene is shown on. It follows the scene, but not during a gesture: the picture would
  /// jump under the hand.
  [[nodiscard]] const Stage &stage() const { return m_scene.stage(); }
  /// Whoever lets the user choose sets it.
  [[nodiscard]] Snapping &snapping() { return m_snapping; }

  /// Other lessons, or newer ones. The lesson that is open stays, as it was where it is not among them; its
  /// step and its scene stay as far as they fit the new one.
  void setLibrary(LessonLibrary library);
  /// Opens another lesson where it was left, or from its start; the one that is open stays as it is. The
  /// history begins anew, and not clean: what was changed is still not saved.
  void openLesson(const std::string &id);
  /// The sessions of other lessons that were left with changes, by lesson.
  [[nodiscard]] std::map<std::string, Session> &leftSessions() { return m_left; }
  /// Starts anew with a session, as from a file, and with the library that comes with it: other lessons, or
  /// newer ones. The history is empty then. A lesson that is not in the library shows the scene without
  /// words.
  void startWith(Session session, std::optional<LessonLibrary> library = {});
  void setStep(int step);
  /// The constructions whose lines are shown in Explore; in other lessons their steps say it. Whether they
  /// are others than before.
  bool showWorkings(const std::vector<std::string> &constructions);
  /// Who knows whether the current step's question is answered, if it has one: see shownIn. It is asked for
  /// every outcome; before, each question counts as answered.
  void setQuestionOf(std::function<Question()> questionOf);
  /// The question may have been answered, or be open again.
  void takeQuestion();

signals:
  void outcomeChanged(); ///< after every change of scene, stage, step or question
  void lessonChanged();  ///< before outcomeChanged, when another lesson is shown
  void stepChanged();    ///< before outcomeChanged, when another step or lesson is shown
  void sceneReplaced();  ///< after outcomeChanged, when all of the lesson's scene is another one at once

private:
  /// Keeps the lesson that is open, for whoever hears of the history while the library becomes another.
  void keepLesson();
  /// Goes to a session without a step in the history.
  void show(Session session);
  /// Shows the session of the history, which was another one before.
  void showSince(const Session &before);

  LessonLibrary m_library;
  Lesson m_unknownLesson; ///< stands in for the lesson of a file that the library does not have
  const Lesson *m_lesson = nullptr;
  LessonStep m_exploreStep; ///< of Explore
  SessionHistory m_history;
  ShownScene m_scene;
  std::function<Question()> m_questionOf = [] { return Question::Answered; };
  std::map<std::string, Session> m_left;
  Snapping m_snapping;
};

[[nodiscard]] inline bool isExplore(const SessionModel &model) { return model.session().lesson == exploreId; }

/// Whether the scene is another one than the lesson begins with.
[[nodiscard]] inline bool isChanged(const SessionModel &model) {
  return !(model.session().scene == model.lesson().scene);
}

/// What the step's tasks ask of a handle as it is on the stage. They speak of the scene's own numbers: of
/// none on a stage with others.
[[nodiscard]] std::vector<SnapTarget> askedOf(const SessionModel &model, const Handle &handle);

} // namespace halfspace
