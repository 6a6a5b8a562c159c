// The history of a session: edits of every sort, undone and done again.
#include "widgets/session_model.h"

#include "lessons/object/point.h"
#include "tests/lessons/scene/random_edits.h"

#include <QtTest>

using namespace halfspace;

namespace {

LessonLibrary library() { return readLessons(TEST_LESSONS_FOLDER); }

constexpr int editsPerSeed = 300;

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
        const QString refusal = model.edit(random.next(before.scene), "edit");
        if (!refusal.isEmpty())
          QVERIFY(model.session() == before);
        else if (!(model.session() == before))
          sessions.push_back(model.session());
      }
      QCOMPARE(model.history().count(), static_cast<int>(sessions.size()) - 1);
      for (auto session = sessions.rbegin() + 1; session != sessions.rend(); ++session) {
        model.undo();
        QVERIFY(model.session() == *session);
      }
      for (auto session = sessions.begin() + 1; session != sessions.end(); ++session) {
        model.redo();
        QVERIFY(model.session() == *session);
      }
      // What came of all that is what the scene comes to anew.
      QVERIFY(figureOf(model.evaluation()).marks == figureOf(evaluate(model.session().scene)).marks);
      steps += static_cast<int>(sessions.size());
    }
    QVERIFY2(steps > 1000, qPrintable(QString::number(steps)));
  }

  void gesture_settledByAnEdit_isAStepOfItsOwn() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    QSignalSpy settled(&model, &SessionModel::gestureSettled);
    const Session before = model.session();
    model.beginGesture("Move Q");
    model.moveGesture(ChangeObject{"Q", PointObject{{1, 2, 3}}});
    QCOMPARE(model.edit(RenameEntry{"Q", "S"}, "rename"), QString());
    QCOMPARE(settled.count(), 1);
    QVERIFY(!model.inGesture());
    model.moveGesture(ChangeObject{"S", PointObject{{9, 9, 9}}}); // nobody holds it any more
    QVERIFY(findObject(model.session().scene, "S")->operator[](0) == ExactVec3(1, 2, 3));
    QCOMPARE(model.history().text(0), QString("Move Q"));
    model.undo();
    QVERIFY(findObject(model.session().scene, "Q") != nullptr);
    model.undo();
    QVERIFY(model.session().scene == before.scene);
  }

  void gesture_tellsWhichObjectsItHasMoved_andThatItBeginsAndEnds() {
    SessionModel model(library());
    model.openLesson("signed-distance");
    QSignalSpy changed(&model, &SessionModel::gestureChanged);
    for (const bool keep : {true, false}) {
      model.beginGesture("Move Q");
      QVERIFY(!model.isMovedByGesture("Q"));
      model.moveGesture(ChangeObject{"Q", PointObject{{1, 2, keep ? 3 : 4}}});
      QVERIFY(model.isMovedByGesture("Q"));
      QVERIFY(!model.isMovedByGesture("E"));
      if (keep)
        model.endGesture();
      else
        model.cancelGesture();
      QVERIFY(!model.isMovedByGesture("Q"));
    }
    QCOMPARE(changed.count(), 4);
  }

  void gesture_thatALessonIsOpenedIn_isLetGo() {
    SessionModel model(library());
    QSignalSpy settled(&model, &SessionModel::gestureSettled);
    QSignalSpy changed(&model, &SessionModel::gestureChanged);
    model.beginGesture("Move Q");
    model.startWith({"signed-distance", 0, model.library().find("signed-distance")->scene});
    QCOMPARE(settled.count(), 1);
    QCOMPARE(changed.count(), 2);
    QVERIFY(!model.inGesture());
    QCOMPARE(model.history().count(), 0);
  }
};

QTEST_MAIN(SessionModelTest)
#include "session_model_test.moc"
