// The history of a session: edits of every sort, undone and done again.
#include "widgets/session_model.h"

#include "lessons/object/kinds/point.h"
#include "tests/lessons/scene/random_edits.h"

#include <QtTest>

#include <algorithm>
#include <functional>

using namespace halfspace;

namespace {

LessonLibrary library() { return readLessons(TEST_LESSONS_FOLDER); }

constexpr int editsPerSeed = 300;

LessonLibrary with(LessonLibrary library, const Lesson &newer) {
  library.put(newer);
  return library;
}

} // namespace

class SessionModelTest : public QObject {
  Q_OBJECT

private slots:
  void randomEdits_undoneAndRedone_giveEqualSessions() {
    int steps = 0;
    for (std::uint64_t seed = 0; seed < 18; ++seed) {
      SessionModel model(library());
      test::RandomEdits random(seed);
      std::vector<Session> sessions{model.session()};
      for (int i = 0; i < editsPerSeed; ++i) {
        const Session before = model.session();
        const QString refusal = model.history().edit(random.next(before.scene), "edit");
        if (!refusal.isEmpty())
          QVERIFY(model.session() == before);
        else if (!(model.session() == before))
          sessions.push_back(model.session());
      }
      QCOMPARE(model.history().count(), static_cast<int>(sessions.size()) - 1);
      for (auto session = sessions.rbegin() + 1; session != sessions.rend(); ++session) {
        model.history().undo();
        QVERIFY(model.session() == *session);
      }
      for (auto session = sessions.begin() + 1; session != sessions.end(); ++session) {
        model.history().redo();
        QVERIFY(model.session() == *session);
      }
      // What came of all that is what the scene comes to anew.
      QVERIFY(figureOf(model.evaluation()).marks == figureOf(evaluate(model.session().scene)).marks);
      steps += static_cast<int>(sessions.size());
    }
    QVERIFY2(steps > 1000, qPrintable(QString::number(steps)));
  }

  void begunOnASession_isAtItsStepAndScene_withNothingToUndo() {
    const LessonLibrary lessons = library();
    Session asked{"signed-distance", 2, lessons.find("signed-distance")->scene};
    setObject(asked.scene, "Q", PointObject{{1, 2, 3}});
    const SessionModel model(lessons, asked);
    QVERIFY(model.session() == asked);
    QCOMPARE(model.step().title, lessons.find("signed-distance")->steps[2].title);
    QVERIFY(figureOf(model.evaluation()).marks == figureOf(evaluate(asked.scene)).marks);
    QVERIFY(isChanged(model));
    QVERIFY(!model.history().undoText());
    QVERIFY(model.history().isClean());
  }

  void begunOnASession_withAStepThatIsNot_isAtTheNearest() {
    const LessonLibrary lessons = library();
    const Lesson &lesson = *lessons.find("signed-distance");
    const SessionModel model(lessons, {lesson.id, 999, lesson.scene});
    QCOMPARE(model.session().step, static_cast<int>(lesson.steps.size()) - 1);
  }

  void step_thatTheLessonHasNot_isTheNearest() {
    SessionModel model(library());
    const int last = static_cast<int>(model.lesson().steps.size()) - 1;
    model.setStep(99);
    QCOMPARE(model.session().step, last);
    model.setStep(-1);
    QCOMPARE(model.session().step, 0);
  }

  void lessonRenewed_withOtherWordsOrNumbers_keepsStepAndChangedScene() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    model.setStep(2);
    model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "edit");
    const Session before = model.session();
    Lesson newer = model.lesson();
    newer.steps[2].title = "Other words";
    setObject(newer.scene, "Q", PointObject{{9, 9, 9}});
    QSignalSpy shown(&model, &SessionModel::lessonChanged);
    model.setLibrary(with(model.library(), newer));
    QCOMPARE(shown.count(), 1);
    QVERIFY(model.session() == before);
    QCOMPARE(model.step().title, std::string("Other words"));
    model.history().undo(); // what was done is still there
    QVERIFY(!(model.session().scene == before.scene));
    model.history().replaceScene(model.lesson().scene, "Start over");
    QVERIFY(model.session().scene == newer.scene);
  }

  void lessonRenewed_withAnotherScene_orWhileNothingWasChanged_beginsItAnew() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    model.setStep(3);
    Lesson newer = model.lesson();
    setObject(newer.scene, "Q", PointObject{{9, 9, 9}});
    newer.steps.resize(2);
    model.setLibrary(with(model.library(), newer));
    QVERIFY(model.session().scene == newer.scene);
    QCOMPARE(model.session().step, 1);
    model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "edit");
    newer.scene.entries.push_back({"S", PointObject{{0, 0, 0}}});
    model.setLibrary(with(model.library(), newer));
    QVERIFY(model.session().scene == newer.scene);
    QVERIFY(!model.history().undoText());
  }

  void lessonRenewed_whileItsHistoryEnds_isTheLessonOfBeforeToWhoeverLooks() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    Lesson newer = model.lesson();
    const std::string title = "A title that is too long to stand within its string";
    newer.title = title;
    model.setLibrary(with(model.library(), newer));
    model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "edit");
    model.history().setClean();
    model.history().undo();
    int looks = 0;
    connect(&model.history(), &SessionHistory::cleanChanged, &model, [&] {
      ++looks;
      QCOMPARE(model.lesson().title, title);
    });
    newer.title = "Another title that is too long to stand within its string";
    newer.scene.entries.push_back({"S", PointObject{{0, 0, 0}}});
    model.setLibrary(with(model.library(), newer));
    QCOMPARE(looks, 1);
    QCOMPARE(model.lesson().title, newer.title);
  }

  void openLesson_thatANewerLibraryLacks_staysOpen() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    const Lesson open = model.lesson();
    LessonLibrary others = library();
    std::erase_if(others.lessons, [](const Lesson &each) { return each.id == "signed-distance"; });
    model.setLibrary(others);
    QCOMPARE(model.lesson().title, open.title);
    QVERIFY(model.session().scene == open.scene);
    model.openLesson("plane-implicit");
    QCOMPARE(model.lesson().id, std::string("plane-implicit"));
  }

  void gesture_settledByAnEdit_isAStepOfItsOwn() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    QSignalSpy settled(&model.history(), &SessionHistory::gestureSettled);
    const Session before = model.session();
    const GestureToken held = model.history().beginGesture("Move Q");
    model.history().moveGesture(held, ChangeObject{"Q", PointObject{{1, 2, 3}}});
    QCOMPARE(model.history().edit(RenameEntry{"Q", "S"}, "rename"), QString());
    QCOMPARE(settled.count(), 1);
    QVERIFY(!model.history().inGesture());
    model.history().moveGesture(held, ChangeObject{"S", PointObject{{9, 9, 9}}}); // nobody holds it any more
    QVERIFY(findObject(model.session().scene, "S")->operator[](0) == ExactVec3(1, 2, 3));
    QCOMPARE(model.history().text(0), std::string("Move Q"));
    model.history().undo();
    QVERIFY(findObject(model.session().scene, "Q") != nullptr);
    model.history().undo();
    QVERIFY(model.session().scene == before.scene);
  }

  void gesture_thatAnotherHandHolds_isNotGoneOnWithNorEnded() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    const auto place = [&] { return findObject(model.session().scene, "Q")->operator[](0); };
    const GestureToken scrub = model.history().beginGesture("Scrub");
    model.history().moveGesture(scrub, ChangeObject{"Q", PointObject{{1, 2, 3}}});
    const GestureToken flight = model.history().beginGesture("Fly");
    model.history().moveGesture(scrub, ChangeObject{"Q", PointObject{{9, 9, 9}}});
    QVERIFY(place() == ExactVec3(1, 2, 3));
    model.history().endGesture(scrub);
    model.history().cancelGesture(scrub);
    QVERIFY(model.history().isHeldBy(flight) && !model.history().isHeldBy(scrub));
    model.history().moveGesture(flight, ChangeObject{"Q", PointObject{{4, 5, 6}}});
    model.history().endGesture(flight);
    QCOMPARE(model.history().count(), 2);
    QCOMPARE(model.history().text(0), std::string("Scrub"));
    model.history().undo();
    QVERIFY(place() == ExactVec3(1, 2, 3));
    model.history().moveGesture(GestureToken::Nobodys, ChangeObject{"Q", PointObject{{9, 9, 9}}});
    QVERIFY2(place() == ExactVec3(1, 2, 3), "nobody holds anything");
  }

  void editsTogether_areOneStep_andNoneWhereOneIsRefused() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    const Scene before = model.session().scene;
    QCOMPARE(model.history().editTogether({RenameEntry{"Q", "S"}, ChangeObject{"S", PointObject{{1, 2, 3}}}},
                                          "both"),
             QString());
    QCOMPARE(model.history().count(), 1);
    QVERIFY(findObject(model.session().scene, "S")->operator[](0) == ExactVec3(1, 2, 3));
    model.history().undo();
    QVERIFY(model.session().scene == before);
    QVERIFY(!model.history().editTogether({RenameEntry{"Q", "S"}, RemoveEntry{"Q"}}, "refused").isEmpty());
    QVERIFY(model.session().scene == before);
  }

  void gesture_tellsWhichObjectsItHasMoved_andThatItBeginsAndEnds() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    QSignalSpy changed(&model.history(), &SessionHistory::gestureChanged);
    for (const bool keep : {true, false}) {
      const GestureToken held = model.history().beginGesture("Move Q");
      QVERIFY(model.history().movedByGesture().empty());
      model.history().moveGesture(held, ChangeObject{"Q", PointObject{{1, 2, keep ? 3 : 4}}});
      QVERIFY(model.history().movedByGesture() == std::vector<std::string>{"Q"});
      if (keep)
        model.history().endGesture(held);
      else
        model.history().cancelGesture(held);
      QVERIFY(model.history().movedByGesture().empty());
    }
    QCOMPARE(changed.count(), 4);
  }

  void drag_sharesAllThatItDoesNotMove_sceneAndFigureAlike() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    const Scene start = model.session().scene;
    QVERIFY(start.entries.find("E") == model.lesson().scene.entries.find("E"));
    const Figure before = model.shown().figure;
    QVERIFY(findMark(before, "E.n") == findMark(model.figure(), "E.n"));
    const GestureToken held = model.history().beginGesture("Move Q");
    model.history().moveGesture(held, ChangeObject{"Q", PointObject{{1, 2, 3}}});
    QVERIFY(model.session().scene.entries.find("E") == start.entries.find("E"));
    QVERIFY(model.session().scene.entries.find("Q") != start.entries.find("Q"));
    QVERIFY(model.evaluation().scene.entries.find("Q") == model.session().scene.entries.find("Q"));
    const Figure &after = model.shown().figure;
    QVERIFY(findMark(after, "E.n") == findMark(before, "E.n"));
    QVERIFY(findMark(after, "Q") != findMark(before, "Q"));
    model.history().cancelGesture(held);
    QVERIFY(model.session().scene.entries.find("Q") == start.entries.find("Q"));
  }

  void history_isToldOnceForEachChange_thoughItOnlyForgets() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    QSignalSpy told(&model.history(), &SessionHistory::stepsChanged);
    QSignalSpy clean(&model.history(), &SessionHistory::cleanChanged);
    model.history().setClean();
    QCOMPARE(clean.count(), 1);
    model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "move");
    QCOMPARE(told.count(), 1);
    QCOMPARE(clean.count(), 2);
    model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "nothing new");
    QCOMPARE(told.count(), 1);
    model.history().undo();
    QCOMPARE(told.count(), 2);
    QCOMPARE(clean.count(), 3);
    QVERIFY(model.history().redoText());
    model.startWith(model.session());
    QVERIFY(!model.history().redoText());
    QCOMPARE(told.count(), 3);
    QCOMPARE(clean.count(), 3);
  }

  void view_isNoUndoStep_andStaysWhateverIsUndone() {
    SessionModel model(library());
    QSignalSpy changed(&model, &SessionModel::outcomeChanged);
    const ChosenView first{{{1, 2, 3}, {0, 0, 0}, 9}, false};
    const ChosenView second{{{3, 2, 1}, {0, 0, 0}, 5}, true};
    model.openLesson("signed-distance");
    changed.clear();
    model.history().setView(first);
    QCOMPARE(model.history().count(), 0);
    QVERIFY(changed.isEmpty());
    QVERIFY(!isChanged(model));
    QCOMPARE(model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "move"), QString());
    model.history().setView(second);
    model.history().undo();
    QVERIFY(model.session().view == second);
    model.history().redo();
    QVERIFY(model.session().view == second);
    const GestureToken held = model.history().beginGesture("Move Q");
    model.history().moveGesture(held, ChangeObject{"Q", PointObject{{7, 7, 7}}});
    model.history().setView(first);
    model.history().cancelGesture(held);
    QVERIFY(model.session().view == first);
    model.history().replaceScene(model.lesson().scene, "Start over");
    QVERIFY(model.session().view == first);
  }

  void view_ofALessonThatWasLeftChanged_isThereAgain_andAnotherBeginsWithItsOwn() {
    SessionModel model(library());
    const ChosenView mine{{{1, 2, 3}, {0, 0, 0}, 9}, true};
    model.openLesson("signed-distance");
    model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "move");
    model.history().setView(mine);
    model.openLesson("plane-implicit");
    QVERIFY(!model.session().view);
    model.openLesson("signed-distance");
    QVERIFY(model.session().view == mine);
  }

  void questionThatIsOpen_hidesTheMarksThatAreDerived() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    const auto hasResults = [&] {
      const auto &marks = model.shown().figure.marks;
      return std::any_of(marks.begin(), marks.end(),
                         [](const Mark &mark) { return baseOf(mark).role != Role::Given; });
    };
    model.setStep(2);
    QVERIFY(hasResults());
    Question question = Question::Answered;
    model.setQuestionOf([&] { return question; });
    QSignalSpy changed(&model, &SessionModel::outcomeChanged);
    question = Question::Open;
    model.takeQuestion();
    QVERIFY(!hasResults());
    QVERIFY(!model.shown().figure.marks.empty());
    QCOMPARE(changed.count(), 1);
    model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "move");
    QVERIFY(!hasResults());
    question = Question::Answered;
    model.takeQuestion();
    QVERIFY(hasResults());
    QCOMPARE(changed.count(), 3);
    model.takeQuestion(); // as it is
    QCOMPARE(changed.count(), 3);
  }

  void questionOfAStep_thatIsOpenedAsItIsTurnedTo_showsTheOutcomeOnce() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    model.setQuestionOf([&] { return model.session().step == 2 ? Question::Open : Question::Answered; });
    QSignalSpy changed(&model, &SessionModel::outcomeChanged);
    model.setStep(2);
    QCOMPARE(changed.count(), 1);
    const auto &marks = model.shown().figure.marks;
    QVERIFY(std::all_of(marks.begin(), marks.end(),
                        [](const Mark &mark) { return baseOf(mark).role == Role::Given; }));
  }

  void gesture_tellsWhenItBeginsAndWhenItEnds_howeverItEnds() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    std::vector<bool> told;
    GestureToken held = GestureToken::Nobodys;
    connect(&model.history(), &SessionHistory::gestureChanged, this,
            [&] { told.push_back(model.history().inGesture()); });
    const std::vector<std::function<void()>> ends{
        [&] { model.history().endGesture(held); }, [&] { model.history().cancelGesture(held); },
        [&] {
          model.history().edit(ChangeObject{"Q", PointObject{{4, 5, 6}}}, "typed");
        },
        [&] { model.history().undo(); }, [&] { model.startWith(model.session()); }};
    for (const auto &end : ends) {
      told.clear();
      held = model.history().beginGesture("Move Q");
      model.history().moveGesture(held, ChangeObject{"Q", PointObject{{1, 2, 3}}});
      end();
      QVERIFY(told == (std::vector{true, false}));
    }
  }

  void gesture_thatALessonIsOpenedIn_isLetGo() {
    SessionModel model(library());
    QSignalSpy settled(&model.history(), &SessionHistory::gestureSettled);
    QSignalSpy changed(&model.history(), &SessionHistory::gestureChanged);
    static_cast<void>(model.history().beginGesture("Move Q"));
    model.startWith({"signed-distance", 0, model.library().find("signed-distance")->scene});
    QCOMPARE(settled.count(), 1);
    QCOMPARE(changed.count(), 2);
    QVERIFY(!model.history().inGesture());
    QCOMPARE(model.history().count(), 0);
  }
};

QTEST_MAIN(SessionModelTest)
#include "session_model_test.moc"
