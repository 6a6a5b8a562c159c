// One number of a coordinate, typed, stepped and scrubbed into a session.
#include "widgets/numbers/coordinate_editor.h"

#include "lessons/object/kinds/number.h"
#include "lessons/reading/typed_number.h"
#include "tests/lessons/scenes.h"
#include "widgets/numbers/number_field.h"

#include <QtTest>

#include <memory>

using namespace halfspace;
using test::q;

namespace {

Entry numberK(const Rational &step) { return {"k", NumberObject{2, -10, 10, step}}; }

/// A model that shows this scene in its first lesson.
void start(SessionModel &model, const Scene &scene) { model.startWith({model.lesson().id, 0, scene}); }

ExactVec3 valueOf(const SessionModel &model, const CoordinateId &id) {
  return coordinate(*findObject(model.session().scene, id.object), id.index);
}

const CoordinateId q0{"Q", 0};

} // namespace

class CoordinateEditorTest : public QObject {
  Q_OBJECT

private slots:
  void init() {
    m_model = std::make_unique<SessionModel>(readLessons(TEST_LESSONS_FOLDER));
    m_editor = std::make_unique<CoordinateEditor>(*m_model);
    start(*m_model, test::distanceScene());
  }
  void cleanup() {
    m_editor.reset();
    m_model.reset();
  }

  void typedNumberChangesItsAxisOnly_inOneStepThatIsNamed_data() {
    QTest::addColumn<int>("axis");
    QTest::newRow("x") << 0;
    QTest::newRow("y") << 1;
    QTest::newRow("z") << 2;
  }
  void typedNumberChangesItsAxisOnly_inOneStepThatIsNamed() {
    QFETCH(int, axis);
    ExactVec3 expected = valueOf(*m_model, q0);
    expected[axis] = q(10, 3);
    m_editor->change({q0, axis}, q(10, 3));
    QVERIFY(valueOf(*m_model, q0) == expected);
    QCOMPARE(m_model->history().count(), 1);
    QCOMPARE(m_model->history().undoText().value(), std::string("Move Q"));
    m_model->history().undo();
    QVERIFY(m_model->session().scene == test::distanceScene());
  }

  void stepNamesTheCoordinateOfItsObject() {
    m_editor->change({{"E", 1}, 0}, 4);
    QCOMPARE(m_model->history().undoText().value(), std::string("Move the tip of n"));
  }

  void numberThatTheSessionDoesNotTake_changesNothing_data() {
    QTest::addColumn<QString>("object");
    QTest::addColumn<QString>("value");
    QTest::newRow("too large") << "Q"
                               << "1000000001";
    QTest::newRow("too small") << "Q"
                               << "-1000000001";
    QTest::newRow("too long") << "Q"
                              << "1/" + QString("3").repeated(int(coordinateDigits) + 1);
    QTest::newRow("of no object") << "nobody"
                                  << "1";
  }
  void numberThatTheSessionDoesNotTake_changesNothing() {
    QFETCH(QString, object);
    QFETCH(QString, value);
    const CoordinateNumber number{{object.toStdString(), 0}, 0};
    m_editor->change(number, *parseTyped(value));
    m_editor->step(number, object == "Q" ? 2000000000 : 1);
    m_editor->beginScrub(number);
    m_editor->scrub(object == "Q" ? 2000000000 : 1);
    m_editor->endScrub(true);
    QVERIFY(m_model->session().scene == test::distanceScene());
    QCOMPARE(m_model->history().count(), 0);
  }

  void stepIsThatOfTheSnapping_data() {
    QTest::addColumn<QString>("snap");
    QTest::addColumn<int>("steps");
    QTest::addColumn<QString>("moved");
    QTest::newRow("one up") << "1" << 1 << "1";
    QTest::newRow("three down") << "1" << -3 << "-3";
    QTest::newRow("tenths") << "1/10" << 3 << "3/10";
    QTest::newRow("nowhere") << "1" << 0 << "0";
  }
  void stepIsThatOfTheSnapping() {
    QFETCH(QString, snap);
    QFETCH(int, steps);
    QFETCH(QString, moved);
    m_model->snapping().step = *parseTyped(snap);
    m_editor->step({q0, 0}, steps);
    QVERIFY(valueOf(*m_model, q0) == ExactVec3(11 + *parseTyped(moved), 15, 8));
    QCOMPARE(m_model->history().count(), steps == 0 ? 0 : 1);
  }

  void stepOfAPositionGrowsWithTheScene() {
    start(*m_model, {{{"P", PointObject{{0, 0, 0}}}, {"Q", PointObject{{11000, 15000, 8000}}}}});
    QVERIFY(m_model->stage().unit() > 1);
    m_editor->step({q0, 1}, 2);
    QVERIFY(valueOf(*m_model, q0) == ExactVec3(11000, 15000 + 2 * m_model->stage().unit(), 8000));
  }

  void stepOfADirectionSuitsItsOwnLength_data() {
    QTest::addColumn<QString>("length");
    QTest::addColumn<QString>("step");
    QTest::newRow("usual") << "2"
                           << "1";
    QTest::newRow("long") << "2000"
                          << "100";
    QTest::newRow("short") << "1/100"
                           << "1/1000";
  }
  void stepOfADirectionSuitsItsOwnLength() {
    QFETCH(QString, length);
    QFETCH(QString, step);
    const Rational z = *parseTyped(length);
    start(*m_model, {{{"E", PlaneObject{{5, 4, 7}, {0, 0, -z}}}, test::pointQ()}});
    m_editor->step({{"E", 1}, 0}, 1);
    const Rational moved = valueOf(*m_model, {"E", 1}).x;
    // A power of ten that leaves the longest number some steps and not too many.
    QVERIFY2(moved == *parseTyped(step), toText(moved).c_str());
  }

  void stepOfANumberIsItsOwn_orElseTheSnapping() {
    start(*m_model, {{numberK(q(1, 4))}});
    m_editor->step({{"k", 0}, 0}, 3);
    QVERIFY(valueOf(*m_model, {"k", 0}).x == q(11, 4));
    start(*m_model, {{numberK(0)}});
    m_model->snapping().step = q(1, 2);
    m_editor->step({{"k", 0}, 0}, 3);
    QVERIFY(valueOf(*m_model, {"k", 0}).x == q(7, 2));
  }

  void scrubGoesFromWhereItBegan_andIsOneStep() {
    m_editor->beginScrub({q0, 2});
    for (const int steps : {1, 5, -2, 3})
      m_editor->scrub(steps);
    QVERIFY(valueOf(*m_model, q0) == ExactVec3(11, 15, 11));
    m_editor->endScrub(true);
    QCOMPARE(m_model->history().count(), 1);
    QCOMPARE(m_model->history().undoText().value(), std::string("Move Q"));
    m_model->history().undo();
    QVERIFY(m_model->session().scene == test::distanceScene());
  }

  void scrubThatIsNotKept_leavesNothing() {
    m_editor->beginScrub({q0, 2});
    m_editor->scrub(4);
    m_editor->endScrub(false);
    QVERIFY(m_model->session().scene == test::distanceScene());
    QCOMPARE(m_model->history().count(), 0);
  }

  void scrubKeepsItsStep_whateverTheDirectionBecomes() {
    start(*m_model, {{{"E", PlaneObject{{5, 4, 7}, {0, 0, 2}}}, test::pointQ()}});
    m_editor->beginScrub({{"E", 1}, 2});
    m_editor->scrub(2000);
    QVERIFY(valueOf(*m_model, {"E", 1}).z == 2002);
    m_editor->scrub(1);
    QVERIFY(valueOf(*m_model, {"E", 1}).z == 3);
    m_editor->endScrub(true);
  }

  void scrubBeyondTheLargestNumber_staysBeforeIt_andComesBack() {
    const Rational start = coordinateLimit - 3;
    const CoordinateId k{"k", 0};
    ::start(*m_model, {{{"k", NumberObject{start, 0, coordinateLimit, 1}}}});
    m_editor->beginScrub({k, 0});
    m_editor->scrub(2);
    m_editor->scrub(7);
    QVERIFY(valueOf(*m_model, k).x == start + 2);
    m_editor->scrub(-7);
    QVERIFY(valueOf(*m_model, k).x == start - 7);
    m_editor->endScrub(true);
    QCOMPARE(m_model->history().count(), 1);
  }

  void scrubThatAnotherSessionEnds_doesNotReachIntoIt() {
    m_editor->beginScrub({q0, 0});
    m_editor->scrub(1);
    start(*m_model, test::distanceScene());
    m_editor->scrub(5);
    m_editor->endScrub(true);
    QVERIFY(m_model->session().scene == test::distanceScene());
    QCOMPARE(m_model->history().count(), 0);
  }

private:
  std::unique_ptr<SessionModel> m_model;
  std::unique_ptr<CoordinateEditor> m_editor;
};

QTEST_MAIN(CoordinateEditorTest)
#include "coordinate_editor_test.moc"
