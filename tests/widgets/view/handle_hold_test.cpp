// A handle in the hand, without a window: what reaches the model, and when.
#include "widgets/view/handle_hold.h"

#include "tests/lessons/scenes.h"
#include "tests/widgets/libraries.h"

#include <QtTest>

using namespace halfspace;
using namespace halfspace::test;

namespace {

struct Fixture {
  SessionModel model{libraryOf({distanceScene()})};
  HandleHold hold{model};
  View view{Camera(), {900, 600}};

  Fixture() {
    view.camera.target = {8, 8, 4};
    view.camera.height = 40;
  }

  ExactVec3 value(const std::string &object) {
    return coordinate(*findObject(model.session().scene, object), 0);
  }
  glm::dvec2 pixelOf(const std::string &id) {
    return glm::dvec2(view.camera.project(shownPlace(handle(model.session().scene, id)), view.size).value());
  }
  void begin(const std::string &id, DragMode mode) {
    hold.begin(handle(model.session().scene, id), mode, pixelOf(id));
  }
};

} // namespace

class HandleHoldTest : public QObject {
  Q_OBJECT

private slots:
  void manyMoves_areFollowedOnce() {
    Fixture fixture;
    fixture.begin("Q", DragMode::Horizontal);
    QSignalSpy outcomes(&fixture.model, &SessionModel::outcomeChanged);
    QSignalSpy pointed(&fixture.hold, &HandleHold::pointed);
    const glm::dvec2 from = fixture.pixelOf("Q");
    for (int x = 1; x <= 60; ++x)
      fixture.hold.pointTo(from + glm::dvec2(x, 0), false);
    QCOMPARE(pointed.count(), 60);
    QCOMPARE(outcomes.count(), 0);
    fixture.hold.follow(fixture.view);
    fixture.hold.follow(fixture.view); // nothing new
    QCOMPARE(outcomes.count(), 1);
    QVERIFY(fixture.value("Q") != ExactVec3(11, 15, 8));
    QVERIFY(fixture.value("Q").z == 8);
  }

  void end_keepsWhatWasMoved_orPutsItBack() {
    Fixture fixture;
    for (const bool stays : {true, false}) {
      const ExactVec3 before = fixture.value("Q");
      fixture.begin("Q", DragMode::Horizontal);
      fixture.hold.pointTo(fixture.pixelOf("Q") + glm::dvec2(60, 20), false);
      fixture.hold.follow(fixture.view);
      QVERIFY(fixture.value("Q") != before);
      fixture.hold.end(stays);
      fixture.hold.letGo();
      QCOMPARE(fixture.value("Q") != before, stays);
      QVERIFY(!fixture.hold.isHolding());
      QVERIFY(!fixture.model.history().inGesture());
    }
    QCOMPARE(fixture.hold.dragCount(), 1);
    QCOMPARE(fixture.model.history().count(), 1);
  }

  void suspended_movesInFinestSteps_atOnce_butNotBeforeThePointerMoves() {
    Fixture fixture;
    fixture.begin("Q", DragMode::Horizontal);
    QSignalSpy pointed(&fixture.hold, &HandleHold::pointed);
    fixture.hold.setSuspended(true);
    QCOMPARE(pointed.count(), 0);
    fixture.hold.pointTo(fixture.pixelOf("Q") + glm::dvec2(53, 9), false);
    fixture.hold.follow(fixture.view);
    QVERIFY(fixture.value("Q").x.denominator() == 1);
    fixture.hold.setSuspended(true);
    QCOMPARE(pointed.count(), 2);
    fixture.hold.follow(fixture.view);
    QVERIFY(fixture.value("Q").x.denominator() != 1);
  }

  void mode_canBeAnother_unlessTheHandleHasItsOwn() {
    Fixture fixture;
    QVERIFY(!fixture.hold.mode());
    QSignalSpy changed(&fixture.hold, &HandleHold::modeChanged);
    fixture.hold.setMode(DragMode::AxisX); // of nothing
    QCOMPARE(changed.count(), 0);
    fixture.begin("E.offset", DragMode::OwnAxis);
    fixture.hold.setMode(DragMode::AxisX);
    QVERIFY(fixture.hold.mode() == DragMode::OwnAxis);
    fixture.hold.end(false);
    fixture.hold.letGo();
    fixture.begin("Q", DragMode::Horizontal);
    fixture.hold.setMode(DragMode::AxisX);
    QVERIFY(fixture.hold.mode() == DragMode::AxisX);
    QCOMPARE(changed.count(), 1);
  }

  void gestureThatSomethingElseEnded_movesNothingAnyMore() {
    Fixture fixture;
    fixture.begin("Q", DragMode::Horizontal);
    fixture.model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "typed");
    fixture.hold.pointTo(fixture.pixelOf("Q") + glm::dvec2(60, 20), false);
    fixture.hold.follow(fixture.view);
    QVERIFY(fixture.value("Q") == ExactVec3(1, 2, 3));
  }

  void caughtCase_isToldUntilItIsLetGo() {
    Fixture fixture;
    QSignalSpy caught(&fixture.hold, &HandleHold::caughtChanged);
    fixture.begin("Q", DragMode::Horizontal);
    // At z = 8 the plane's points are x + 2y = 11.
    fixture.hold.pointTo(glm::dvec2(fixture.view.camera.project({3, 4, 8}, fixture.view.size).value()),
                         false);
    fixture.hold.follow(fixture.view);
    QCOMPARE(fixture.hold.caught(), std::string("plane E"));
    QCOMPARE(caught.count(), 1);
    fixture.hold.end(true);
    fixture.hold.letGo();
    QCOMPARE(fixture.hold.caught(), std::string());
    QCOMPARE(caught.count(), 2);
  }
};

QTEST_GUILESS_MAIN(HandleHoldTest)
#include "handle_hold_test.moc"
