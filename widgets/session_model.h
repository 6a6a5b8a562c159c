// The session that the window works on, its outcome, and its history.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/shown.h"
#include "lessons/scene/hand/snap_targets.h"
#include "lessons/scene/history.h"
#include "widgets/picture/stage.h"

#include <QObject>

#include <map>

namespace halfspace {

/// Owns the window's one session. Views are written from `evaluation()` and send edits back; they hold no
/// truth.
class SessionModel : public QObject {
  Q_OBJECT

public:
  /// Requires at least one lesson.
  explicit SessionModel(LessonLibrary library, QObject *parent = nullptr);

  [[nodiscard]] const LessonLibrary &library() const { return m_library; }
  [[nodiscard]] const Session &session() const { return m_history.session(); }
  [[nodiscard]] const Lesson &lesson() const { return *m_lesson; }
  /// What the scene comes to.
  [[nodiscard]] const Evaluation &evaluation() const { return m_evaluation; }
  /// All of its marks.
  [[nodiscard]] const Figure &figure() const { return m_figure; }
  /// The current step; of a lesson that is not in the library, one that shows everything.
  [[nodiscard]] const LessonStep &step() const;
  /// What the current step shows of the scene.
  [[nodiscard]] const Shown &shown() const { return m_shown; }
  /// What was done to the session, and the gesture that goes on.
  [[nodiscard]] const History &history() const { return m_history; }
  /// What the step's tasks ask of a handle as it is on the stage. They speak of the scene's own numbers: of
  /// none on a stage with others.
  [[nodiscard]] std::vector<SnapTarget> askedOf(const Handle &handle) const;
  /// The stage that the scene is shown on. It follows the scene, but not during a gesture: the picture would
  /// jump under the hand.
  [[nodiscard]] const Stage &stage() const { return m_stage; }
  /// The steps in which handles move when dragged or stepped by keys, in units of the stage.
  [[nodiscard]] const Rational &snapStep() const { return m_snapStep; }
  void setSnapStep(const Rational &step) { m_snapStep = step; }
  /// Whether what is dragged snaps; keys go in steps all the same.
  [[nodiscard]] bool isSnapping() const { return m_isSnapping; }
  void setSnapping(bool on) { m_isSnapping = on; }

  /// Other lessons, or newer ones. The lesson that is open stays, as it was where it is not among them; its
  /// step and its scene stay as far as they fit the new one.
  void setLibrary(LessonLibrary library);
  /// Puts a newer lesson in the place of the one with its id, likewise.
  void renewLesson(Lesson lesson);
  /// Opens another lesson where it was left, or from its start; the one that is open stays as it is. The
  /// history begins anew, and not clean: what was changed is still not saved.
  void openLesson(const std::string &id);
  /// The sessions of other lessons that were left with changes.
  [[nodiscard]] const std::map<std::string, Session> &leftSessions() const { return m_left; }
  void setLeftSessions(std::map<std::string, Session> sessions) { m_left = std::move(sessions); }
  /// Whether the scene is another one than the lesson begins with.
  [[nodiscard]] bool isChanged() const { return !(session().scene == m_lesson->scene); }
  /// Starts anew with a session, as from a file: its history is empty. A lesson that is not in the library
  /// shows the scene without words.
  void startWith(Session session);
  /// What goes on under the hand ends first, and is what is undone.
  void undo();
  void redo();
  /// The session is as it is saved; or saved nowhere, now and after any undo.
  void setClean();
  void resetClean();
  /// Puts the current lesson's scene back to its start, as one undo step.
  void resetScene();
  /// Gives the scene other short numbers, as one undo step; see short_numbers.h.
  void renewNumbers(std::uint64_t seed);
  void setStep(int step);
  /// Where the scene is looked at from now; nothing: as the lesson begins. No undo step, and no change.
  void setView(const std::optional<ChosenView> &view);
  /// Whether the current step's question is answered, if it has one: see shownIn.
  void setQuestion(Question question);

  /// An edit that stands on its own: one undo step. Why it is refused; else empty.
  QString edit(const Edit &edit, const QString &description) { return editTogether({edit}, description); }
  /// Several, each of what those before it leave: one undo step, or none of them where one is refused.
  QString editTogether(const std::vector<Edit> &edits, const QString &description);

  /// Between beginGesture and endGesture all edits are one undo step; cancelGesture restores what was there
  /// before. Whatever else changes the scene, begins a gesture or leaves the lesson ends this one first, as
  /// it is: see History.
  [[nodiscard]] GestureToken beginGesture(const QString &description);
  void moveGesture(GestureToken token, const Edit &edit);
  void endGesture(GestureToken token);
  void cancelGesture(GestureToken token);
  [[nodiscard]] bool inGesture() const { return m_history.inGesture(); }
  [[nodiscard]] bool isHeldBy(GestureToken token) const { return m_history.isHeldBy(token); }

signals:
  void historyChanged(); ///< there are other steps to be undone or done again
  void cleanChanged();   ///< the session is not any more as it is saved, or is again
  void gestureChanged(); ///< one has begun, or ended in whatever way
  void gestureSettled(); ///< a gesture has ended because something else was done
  void outcomeChanged(); ///< after every change of scene, stage, step or question
  void lessonChanged();  ///< before outcomeChanged, when another lesson is shown
  void stepChanged();    ///< before outcomeChanged, when another step or lesson is shown
  void sceneReplaced();  ///< after outcomeChanged, when all of the lesson's scene is another one at once

private:
  /// Goes to a session without a step in the history.
  void show(Session session);
  /// Shows the session of the history, which was another one before.
  void showSince(const Session &before);
  void takeShown();
  [[nodiscard]] int lastStep() const;
  /// Tells what has become of the history since it was told last.
  void tellHistory();
  void showUndone(const Session &before, const HistoryStep *step);
  void clearHistory();
  /// True where the stage is another one now.
  bool takeStage();
  void finishGesture(GestureToken token);
  void settleGesture();
  /// The same for what brings another history: nothing is recorded.
  void dropGesture();
  /// Another scene for the same lesson and step, as one undo step.
  void replaceScene(Scene scene, const QString &description);

  LessonLibrary m_library;
  Lesson m_unknownLesson; ///< stands in for the lesson of a file that the library does not have
  const Lesson *m_lesson = nullptr;
  History m_history;
  std::pair<int, int> m_toldSteps; ///< of the history: how many are done, and how many there are
  bool m_toldClean = true;
  Evaluation m_evaluation;
  Figure m_figure;
  Question m_question = Question::Answered;
  Shown m_shown;
  std::map<std::string, Session> m_left; ///< by lesson
  Stage m_stage;
  Rational m_snapStep = 1;
  bool m_isSnapping = true;
};

} // namespace halfspace
