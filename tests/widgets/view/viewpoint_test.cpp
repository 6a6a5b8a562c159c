// The camera of a view, without a window: at home and away, back to earlier views, other sizes and stages.
#include "widgets/view/viewpoint.h"

#include "tests/lessons/scenes.h"
#include "tests/widgets/libraries.h"
#include "widgets/view/picture_hold.h"

#include <QtTest>

using namespace halfspace;
using namespace halfspace::test;

namespace {

struct Fixture {
  Screen screen{{900, 600}, 1, false};
  SessionModel model{libraryOf({distanceScene(), Scene{{pointQ()}}})};
  Viewpoint viewpoint{model, [this] { return screen; }};
  PictureHold picture{viewpoint};

  Fixture() { viewpoint.takeScreen(); }

  void resize(PixelSize size) {
    screen.size = size;
    viewpoint.takeScreen();
  }
  void turnByHand() {
    picture.begin();
    picture.turn(0.2, 0.1);
    picture.turn(0.1, 0.1);
  }
  /// Puts Q elsewhere, as a hand or an inspector does.
  void put(const ExactVec3 &place) {
    QCOMPARE(model.history().edit(ChangeObject{"Q", PointObject{place}}, "put"), QString());
    viewpoint.takeStage();
  }
  bool sees(const Place &place) const {
    const auto pixel = viewpoint.camera().project(place, screen.size);
    return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= screen.size.width &&
           pixel->y <= screen.size.height;
  }
};

constexpr Place placeOfQ{11, 15, 8};

} // namespace

class ViewpointTest : public QObject {
  Q_OBJECT

private slots:
  void atHome_theFigureStaysFittedToTheView() {
    Fixture fixture;
    const Camera wide = fixture.viewpoint.camera();
    fixture.resize({200, 600});
    QVERIFY(!(fixture.viewpoint.camera() == wide));
    QVERIFY(fixture.sees(placeOfQ));
    fixture.resize({900, 600});
    QVERIFY(fixture.viewpoint.camera() == wide);
    QVERIFY(!fixture.model.session().view);
  }

  void awayFromHome_aViewThatGetsItsSizeBack_hasItsCameraBack() {
    Fixture fixture;
    fixture.turnByHand();
    const Camera mine = fixture.viewpoint.camera();
    fixture.resize({200, 600});
    QVERIFY(fixture.viewpoint.camera().height > mine.height);
    fixture.resize({900, 600});
    QVERIFY(fixture.viewpoint.camera() == mine);
    fixture.viewpoint.setCovered({{{0, 0}, {450, 600}}});
    QVERIFY2(fixture.viewpoint.camera() == mine, "what covers the view moves nothing");
  }

  void whileSomethingIsHeld_theFigureIsNotFittedAnew() {
    Fixture fixture;
    const GestureToken held = fixture.model.history().beginGesture("drag");
    fixture.model.history().moveGesture(held, ChangeObject{"Q", PointObject{{25, 15, 8}}});
    const Camera before = fixture.viewpoint.camera();
    fixture.resize({900, 590});
    fixture.viewpoint.setCovered({{{0, 0}, {450, 600}}});
    QVERIFY(fixture.viewpoint.camera() == before);
    fixture.model.history().endGesture(held);
    fixture.viewpoint.takeScreen();
    QVERIFY(!(fixture.viewpoint.camera() == before));
  }

  void home_isWithoutAViewOfItsOwn_elsewhereTheSessionKeepsIt() {
    Fixture fixture;
    fixture.turnByHand();
    const auto view = fixture.model.session().view;
    QVERIFY(view.has_value());
    QCOMPARE(view->view.height, fixture.viewpoint.camera().height);
    fixture.viewpoint.show(NamedView::Home);
    QVERIFY(!fixture.model.session().view);
    fixture.viewpoint.setOrthographic(true);
    fixture.viewpoint.show(NamedView::Home);
    QVERIFY2(fixture.model.session().view && fixture.model.session().view->orthographic,
             "a lesson does not begin like that");
  }

  void previousViews_areThoseBeforeAHandOrAMenuLeftThem() {
    Fixture fixture;
    const Camera home = fixture.viewpoint.camera();
    fixture.turnByHand(); // many moves are one change
    const Camera turned = fixture.viewpoint.camera();
    fixture.picture.begin(); // and then nothing moves
    fixture.picture.zoom(0.9, {450, 300});
    fixture.picture.zoom(0.9, {450, 300});
    const Camera zoomed = fixture.viewpoint.camera();
    fixture.viewpoint.show(NamedView::Top);
    fixture.viewpoint.show(NamedView::Top); // it is there already
    for (const Camera &camera : {zoomed, turned, home}) {
      QVERIFY(!fixture.viewpoint.previous().isEmpty());
      fixture.viewpoint.showPrevious();
      QVERIFY(fixture.viewpoint.camera() == camera);
    }
    QVERIFY(fixture.viewpoint.previous().isEmpty());
    fixture.viewpoint.showPrevious();
    QVERIFY(fixture.viewpoint.camera() == home);
  }

  void previousView_isAsOrthographicAsTheViewIsNow() {
    Fixture fixture;
    fixture.viewpoint.show(NamedView::Top);
    fixture.viewpoint.setOrthographic(true);
    fixture.viewpoint.showPrevious();
    QVERIFY(fixture.viewpoint.camera().orthographic);
  }

  void otherView_whereItMoves_isGlidedTo_untilAHandStopsIt() {
    Fixture fixture;
    fixture.screen.moves = true;
    const Camera before = fixture.viewpoint.camera();
    QSignalSpy moved(&fixture.viewpoint, &Viewpoint::moved);
    fixture.viewpoint.show(NamedView::Top);
    QVERIFY(fixture.viewpoint.camera() == before);
    QTRY_VERIFY(fixture.viewpoint.camera().elevation > before.elevation);
    QVERIFY(moved.count() > 0);
    fixture.viewpoint.stop();
    const Camera stopped = fixture.viewpoint.camera();
    QTest::qWait(60);
    QVERIFY(fixture.viewpoint.camera() == stopped);
    fixture.viewpoint.arrive();
    QVERIFY2(fixture.viewpoint.camera() == stopped, "it is not on its way any more");
    fixture.viewpoint.show(NamedView::Top);
    fixture.viewpoint.arrive();
    QCOMPARE(fixture.viewpoint.camera().elevation, Camera::maxElevation);
  }

  void covered_atHome_theFigureIsBesideIt() {
    Fixture fixture;
    fixture.viewpoint.setCovered({{{0, 0}, {450, 600}}});
    QVERIFY(fixture.viewpoint.camera().project(placeOfQ, fixture.screen.size)->x > 450);
    QSignalSpy changed(&fixture.viewpoint, &Viewpoint::changed);
    fixture.viewpoint.setCovered({{{0, 0}, {450, 600}}});
    QCOMPARE(changed.count(), 0);
  }

  void lesson_isLookedAtAsItsSessionSays_andHasNothingToGoBackTo() {
    Fixture fixture;
    connect(&fixture.model, &SessionModel::lessonChanged, &fixture.viewpoint, &Viewpoint::takeLesson);
    fixture.turnByHand();
    QSignalSpy orthographic(&fixture.viewpoint, &Viewpoint::orthographicChanged);
    const ChosenView close{{{1, 0, 0.5}, {-30, -30, 0}, 3}, true};
    fixture.model.startWith({"lesson1", 0, Scene{{pointQ()}}, close});
    QVERIFY(fixture.viewpoint.camera().target == close.view.at);
    QVERIFY(fixture.viewpoint.camera().orthographic);
    QCOMPARE(orthographic.last().front().toBool(), true);
    QVERIFY(fixture.viewpoint.previous().isEmpty());
    fixture.model.startWith({"lesson0", 0, distanceScene(), {}});
    QVERIFY(!fixture.viewpoint.camera().orthographic);
    QVERIFY(fixture.sees(placeOfQ));
    QVERIFY(!fixture.model.session().view);
  }

  void anotherFigure_isSeenFromHome_orWholeFromWhereTheLearnerStands() {
    Fixture fixture;
    const Camera home = fixture.viewpoint.camera();
    fixture.viewpoint.showAnother();
    QVERIFY(fixture.viewpoint.camera() == home);
    fixture.turnByHand();
    fixture.picture.zoom(0.2, {0, 0});
    QVERIFY(!fixture.sees(placeOfQ));
    const double azimuth = fixture.viewpoint.camera().azimuth;
    fixture.viewpoint.showAnother();
    QVERIFY(fixture.sees(placeOfQ));
    QCOMPARE(fixture.viewpoint.camera().azimuth, azimuth);
  }

  void otherStage_hasAllInView_alsoAwayFromHome() {
    Fixture fixture;
    fixture.turnByHand();
    QVERIFY(!fixture.viewpoint.previous().isEmpty());
    const Stage before = fixture.model.stage();
    fixture.put({1000000, 15, 8});
    const Stage &stage = fixture.model.stage();
    QVERIFY(!(stage == before));
    QVERIFY(fixture.sees(toDouble(toStage({1000000, 15, 8}, CoordinateRole::Position, stage))));
    QVERIFY2(fixture.viewpoint.previous().isEmpty(), "they would be in other units");
  }

  void typedAway_isToldUntilAnotherViewIsChosen() {
    Fixture fixture;
    fixture.viewpoint.noticeTyped({placeOfQ});
    QVERIFY(!fixture.viewpoint.hasTypedAway());
    fixture.viewpoint.noticeTyped({placeOfQ, {500, 15, 8}});
    QVERIFY(fixture.viewpoint.hasTypedAway());
    fixture.viewpoint.noticeTyped({}); // nothing was typed
    QVERIFY(fixture.viewpoint.hasTypedAway());
    fixture.viewpoint.show(NamedView::Fit);
    QVERIFY(!fixture.viewpoint.hasTypedAway());
  }
};

QTEST_GUILESS_MAIN(ViewpointTest)
#include "viewpoint_test.moc"
