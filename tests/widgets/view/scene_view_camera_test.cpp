// Looking around in the 3D view, and what its picture shows.
#include "tests/widgets/view/view_fixture.h"

#include <QSignalSpy>
#include <QWheelEvent>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace halfspace;
using namespace halfspace::test;

namespace {

void turnWheel(ViewFixture &fixture, QPoint at, int clicks) {
  QWheelEvent wheel(at, fixture.view.mapToGlobal(at), {}, {0, 120 * clicks}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&fixture.view, &wheel);
}

bool areNear(double a, double b) { return std::abs(a - b) < 1e-9; }

/// How far a place is from the pixel that it was at.
double pixelsMoved(ViewFixture &fixture, const Place &place, glm::dvec2 before) {
  return glm::length(
      glm::dvec2(*fixture.view.viewpoint().camera().project(place, fixture.view.screen().size())) - before);
}

bool seesAllHandles(ViewFixture &fixture) {
  const auto handles = handlesOf(fixture.model.session().scene);
  return std::all_of(handles.begin(), handles.end(),
                     [&](const Handle &each) { return handlePosition(fixture.view, each.id).has_value(); });
}

} // namespace

class SceneViewCameraTest : public QObject {
  Q_OBJECT

private slots:
  void orthographic_isKeptWithTheSession_alsoAtHome() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.viewpoint().setOrthographic(true);
    fixture.view.viewpoint().show(NamedView::Home);
    QVERIFY(fixture.model.session().view && fixture.model.session().view->orthographic);
    fixture.view.viewpoint().setOrthographic(false);
    fixture.view.viewpoint().show(NamedView::Home);
    QVERIFY(!fixture.model.session().view);
  }

  void sessionOfAnotherLesson_isLookedAtAsItsViewSays_evenFromCloseBy() {
    ViewFixture fixture; // its other lesson has a Q too, elsewhere
    QVERIFY(fixture.ready);
    const ChosenView close{{{1, 0, 0.5}, {-30, -30, 0}, 3}, false};
    Session session{"lesson1", 0, Scene{{{"Q", PointObject{{1, 2, 3}}}}}, close};
    fixture.model.startWith(session);
    QVERIFY(fixture.view.viewpoint().camera().target == close.view.at);
    QVERIFY(areNear(fixture.view.viewpoint().camera().height, close.view.height));
  }

  void sessionThatTheViewBeginsWith_isLookedAtAsItsViewSays() {
    const ChosenView close{{{1, 0, 0.5}, {-30, -30, 0}, 3}, true};
    ViewFixture fixture(libraryOf({distanceScene(), Scene{{pointQ()}}}),
                        {"lesson1", 0, Scene{{pointQ()}}, close});
    QVERIFY(fixture.ready);
    const Camera &camera = fixture.view.viewpoint().camera();
    QVERIFY(camera.target == close.view.at);
    QVERIFY(areNear(camera.height, close.view.height));
    QVERIFY(camera.orthographic);
  }

  void shadows_areThoseOfTheOpenLesson() {
    LessonLibrary library = libraryOf({distanceScene(), distanceScene()});
    library.lessons.back().hasShadows = false;
    ViewFixture fixture(library);
    QVERIFY(fixture.ready);
    QVERIFY(fixture.view.drawn().pictureContent().hasShadows);
    fixture.model.startWith({"lesson1", 0, distanceScene()});
    QVERIFY(!fixture.view.drawn().pictureContent().hasShadows);
  }

  void cameraThatIsMoved_tellsHowTheSelectedHandleMovesFromThere() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.handles().select("Q");
    QSignalSpy hint(&fixture.view, &SceneView::hint);
    const auto told = [&] { return hint.isEmpty() ? QString() : hint.last().front().toString(); };
    fixture.view.viewpoint().show(NamedView::Front); // the ground is seen edge-on from there
    QVERIFY(told().startsWith("Moves up and down"));
    fixture.dragBeside({0, 60});
    QVERIFY(told().startsWith("Moves in x and y"));
    hint.clear();
    fixture.model.history().edit(ChangeObject{"Q", PointObject{{10, 15, 8}}}, "typed");
    QVERIFY2(told().startsWith("Moves in x and y"), "told anew: from its new place it may be otherwise");
  }

  void dragBesideEverything_turnsOrMovesTheCameraByItsButton_data() {
    QTest::addColumn<int>("button");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<bool>("turns");
    QTest::newRow("left") << int(Qt::LeftButton) << int(Qt::NoModifier) << true;
    QTest::newRow("left with shift") << int(Qt::LeftButton) << int(Qt::ShiftModifier) << false;
    QTest::newRow("right") << int(Qt::RightButton) << int(Qt::NoModifier) << false;
    QTest::newRow("middle") << int(Qt::MiddleButton) << int(Qt::NoModifier) << false;
  }

  void dragBesideEverything_turnsOrMovesTheCameraByItsButton() {
    QFETCH(int, button);
    QFETCH(int, modifiers);
    QFETCH(bool, turns);
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Session session = fixture.model.session();
    const Camera before = fixture.view.viewpoint().camera();
    fixture.dragBeside({80, 50}, static_cast<Qt::MouseButton>(button), Qt::KeyboardModifiers(modifiers));
    const Camera &after = fixture.view.viewpoint().camera();
    QCOMPARE(after.azimuth != before.azimuth && after.elevation != before.elevation, turns);
    QCOMPARE(after.height, before.height);
    QVERIFY(fixture.model.session() == session);
  }

  void pan_ofThePicture_followsThePointer() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Place target = fixture.view.viewpoint().camera().target;
    const glm::dvec2 before(*fixture.view.viewpoint().camera().project(target, fixture.view.screen().size()));
    fixture.dragBeside({80, 50}, Qt::RightButton);
    const double ratio = fixture.view.devicePixelRatioF();
    QVERIFY(pixelsMoved(fixture, target, before + glm::dvec2(80, 50) * ratio) < 1e-6);
  }

  void wheel_comesNearerToWhatIsUnderThePointer() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const double height = fixture.view.viewpoint().camera().height;
    const Place target = fixture.view.viewpoint().camera().target;
    const glm::dvec2 pixel(*fixture.view.viewpoint().camera().project(target, fixture.view.screen().size()));
    const double ratio = fixture.view.devicePixelRatioF();
    turnWheel(fixture, QPoint(int(std::lround(pixel.x / ratio)), int(std::lround(pixel.y / ratio))), 3);
    QVERIFY(fixture.view.viewpoint().camera().height < 0.8 * height);
    QVERIFY(pixelsMoved(fixture, target, pixel) < 1);
    turnWheel(fixture, {10, 10}, -3);
    QVERIFY(areNear(fixture.view.viewpoint().camera().height, height));
  }

  void axisViews_lookAgainstTheirAxis_data() {
    QTest::addColumn<int>("view");
    QTest::addColumn<int>("axis");
    QTest::newRow("front") << int(NamedView::Front) << 0;
    QTest::newRow("right") << int(NamedView::Right) << 1;
    QTest::newRow("top") << int(NamedView::Top) << 2;
  }

  void axisViews_lookAgainstTheirAxis() {
    QFETCH(int, view);
    QFETCH(int, axis);
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.viewpoint().show(static_cast<NamedView>(view));
    QVERIFY(fixture.view.viewpoint().camera().viewDirection()[axis] < -0.999);
  }

  void axisViews_afterComingNear_haveAllHandlesInView() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    turnWheel(fixture, {10, 10}, 12);
    QVERIFY(!seesAllHandles(fixture));
    fixture.view.viewpoint().show(NamedView::Top);
    QVERIFY(seesAllHandles(fixture));
  }

  void lookAlongPlane_andDownTheRay_seeThemAsALineAndAPoint() {
    ViewFixture fixture({{planeE(), rayL()}});
    QVERIFY(fixture.ready);
    fixture.view.viewpoint().show(NamedView::AlongPlane);
    QVERIFY(areNear(glm::dot(fixture.view.viewpoint().camera().viewDirection(), Place(1, 2, 2)), 0) ||
            areNear(glm::dot(fixture.view.viewpoint().camera().right(), glm::normalize(Place(1, 2, 0))), 1) ||
            areNear(glm::dot(fixture.view.viewpoint().camera().right(), glm::normalize(Place(1, 2, 0))), -1));
    fixture.view.viewpoint().show(NamedView::DownCourse);
    const Place along = glm::normalize(Place(-1, 3, 2));
    QVERIFY(glm::dot(fixture.view.viewpoint().camera().viewDirection(), along) > 0.999999);
  }

  void homeKey_afterLookingAround_bringsTheFirstViewBack() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Camera home = fixture.view.viewpoint().camera();
    fixture.dragBeside({120, 30});
    turnWheel(fixture, {300, 300}, 4);
    QVERIFY(!(fixture.view.viewpoint().camera() == home));
    fixture.view.viewpoint().show(NamedView::Home);
    QVERIFY(fixture.view.viewpoint().camera() == home);
  }

  void fit_afterComingNear_hasAllHandlesInView_fromTheSameSide() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.dragBeside({120, 30});
    turnWheel(fixture, {10, 10}, 12);
    QVERIFY(!seesAllHandles(fixture));
    const double azimuth = fixture.view.viewpoint().camera().azimuth;
    fixture.view.viewpoint().show(NamedView::Fit);
    QVERIFY(seesAllHandles(fixture));
    QCOMPARE(fixture.view.viewpoint().camera().azimuth, azimuth);
  }

  void resizing_keepsTheFigureInView_untilTheCameraWasMoved() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Camera wide = fixture.view.viewpoint().camera();
    fixture.window.resize(400, 700);
    QTRY_VERIFY(fixture.view.width() < 500);
    QVERIFY(!(fixture.view.viewpoint().camera() == wide));
    QVERIFY(seesAllHandles(fixture));
    fixture.dragBeside({40, 10});
    const Camera mine = fixture.view.viewpoint().camera();
    fixture.window.resize(900, 700);
    QTRY_VERIFY(fixture.view.width() > 500);
    QVERIFY(fixture.view.viewpoint().camera() == mine);
  }

  void resizing_whileAHandleIsHeld_doesNotFitTheFigureAnew() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Camera before = fixture.view.viewpoint().camera();
    const ExactVec3 start = fixture.value("Q");
    fixture.press(fixture.at("Q"));
    movePointer(fixture.view, fixture.at("Q") - QPoint(150, 40), Qt::LeftButton); // the figure is larger now
    QTRY_VERIFY(fixture.value("Q") != start);
    const int height = fixture.view.height();
    fixture.window.resize(fixture.window.width(), fixture.window.height() - 16);
    QTRY_VERIFY(fixture.view.height() < height);
    fixture.view.setCovered({QRect(0, 0, 200, 100)});
    QVERIFY(fixture.view.viewpoint().camera() == before);
    fixture.release(fixture.at("Q"));
  }

  void resizing_afterTheCameraWasMoved_keepsWhatWasBetweenTheSides() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.dragBeside({40, 10});
    const Camera mine = fixture.view.viewpoint().camera();
    QVERIFY(seesAllHandles(fixture));
    fixture.window.resize(300, 700);
    QTRY_VERIFY(fixture.view.width() < 400);
    QVERIFY(seesAllHandles(fixture));
    QCOMPARE(fixture.view.viewpoint().camera().azimuth, mine.azimuth);
    fixture.window.resize(900, 700);
    QTRY_VERIFY(fixture.view.width() > 500);
    QVERIFY2(fixture.view.viewpoint().camera() == mine, "as it was");
  }

  void figure_isFittedBesideWhatCoversTheView() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Camera whole = fixture.view.viewpoint().camera();
    const QRect covered(0, 0, fixture.view.width() / 2, fixture.view.height());
    fixture.view.setCovered({covered});
    for (const Handle &handle : handlesOf(fixture.model.session().scene)) {
      const auto at = handlePosition(fixture.view, handle.id);
      QVERIFY2(at && !covered.contains(*at), handle.id.c_str());
    }
    fixture.dragBeside({40, 10});
    const Camera mine = fixture.view.viewpoint().camera();
    fixture.view.setCovered({});
    QVERIFY2(fixture.view.viewpoint().camera() == mine, "whoever moved the camera keeps it");
    fixture.view.viewpoint().show(NamedView::Home);
    QVERIFY(fixture.view.viewpoint().camera() == whole);
  }

  void glide_withMotion_takesItsTime_andArrivesAtOnceWhenMotionIsTurnedOff() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.setMotion(true);
    const Camera before = fixture.view.viewpoint().camera();
    fixture.view.viewpoint().show(NamedView::Top);
    QVERIFY(fixture.view.viewpoint().camera() == before);
    QTRY_VERIFY(fixture.view.viewpoint().camera().elevation > before.elevation);
    fixture.view.setMotion(false);
    QCOMPARE(fixture.view.viewpoint().camera().elevation, Camera::maxElevation);
  }

  void glide_interruptedByAPress_staysWhereItIs() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.setMotion(true);
    fixture.view.viewpoint().show(NamedView::Top);
    QTest::qWait(50);
    fixture.press({6, 6});
    const Camera stopped = fixture.view.viewpoint().camera();
    QTest::qWait(100);
    QVERIFY(fixture.view.viewpoint().camera() == stopped);
    QVERIFY(stopped.elevation < Camera::maxElevation);
    fixture.release({6, 6});
  }

  void position_typedOutOfView_leavesTheViewAsItIs_andTheHintTellsTheWay() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Camera before = fixture.view.viewpoint().camera();
    QSignalSpy hint(&fixture.view, &SceneView::hint);
    const auto told = [&] { return hint.last().front().toString(); };
    fixture.model.history().edit(ChangeObject{"Q", PointObject{{11, 15, 7}}}, "near by");
    QVERIFY(!told().contains("outside"));
    fixture.model.history().edit(ChangeObject{"Q", PointObject{{100, 15, 8}}}, "far away");
    QVERIFY(fixture.view.viewpoint().camera() == before);
    QVERIFY2(told().contains("outside"), qPrintable(told()));
    fixture.model.history().undo();
    QVERIFY(fixture.view.viewpoint().camera() == before);
    QVERIFY2(!told().contains("outside"), qPrintable(told()));
    fixture.model.history().redo();
    fixture.view.viewpoint().show(NamedView::Fit);
    QVERIFY(handlePosition(fixture.view, "Q"));
    QVERIFY2(!told().contains("outside"), qPrintable(told()));
  }

  void turning_afterTheFigureWasMovedAside_keepsItsMiddleWhereItIs() {
    ViewFixture fixture({{pointQ()}});
    QVERIFY(fixture.ready);
    fixture.dragBeside({-260, 120}, Qt::RightButton);
    QPoint before = fixture.at("Q");
    QVERIFY(fixture.view.rect().contains(before));
    fixture.dragBeside({90, 40});
    QVERIFY2((fixture.at("Q") - before).manhattanLength() <= 2, "it is all that there is");
  }

  void previousView_isThatBeforeTheLastChange_stepByStep() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    QVERIFY(fixture.view.viewpoint().previous().isEmpty());
    const Camera home = fixture.view.viewpoint().camera();
    fixture.dragBeside({80, 30});
    const Camera turned = fixture.view.viewpoint().camera();
    turnWheel(fixture, {300, 300}, 1);
    turnWheel(fixture, {300, 300}, 1); // of one zoom
    fixture.view.viewpoint().show(NamedView::Top);
    fixture.view.viewpoint().showPrevious();
    QVERIFY(fixture.view.viewpoint().camera().height < turned.height);
    fixture.view.viewpoint().showPrevious();
    QVERIFY(fixture.view.viewpoint().camera() == turned);
    fixture.view.viewpoint().showPrevious();
    QVERIFY(fixture.view.viewpoint().camera() == home);
    QVERIFY(fixture.view.viewpoint().previous().isEmpty());
  }

  void click_besideTheFigure_isNoViewToGoBackTo() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.dragBeside({0, 0});
    QVERIFY(fixture.view.viewpoint().previous().isEmpty());
  }

  void facePlane_looksAgainstItsNormal_fromTheSideOfTheEye() {
    ViewFixture fixture({{planeE(), pointQ()}});
    QVERIFY(fixture.ready);
    const Place normal = glm::normalize(Place(1, 2, 2));
    const double side = glm::dot(fixture.view.viewpoint().camera().viewDirection(), normal);
    fixture.view.viewpoint().show(NamedView::FacingPlane);
    const double along = glm::dot(fixture.view.viewpoint().camera().viewDirection(), normal);
    QVERIFY(std::abs(along) > 0.999999);
    QVERIFY(along * side > 0);
    QVERIFY(seesAllHandles(fixture));
  }

  void hugeScene_isInView_onAStageOfItsOwn() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.model.history().edit(ChangeObject{"Q", PointObject{{1000000, 15, 8}}}, "very far away");
    QVERIFY(handlePosition(fixture.view, "Q"));
    fixture.view.handles().select("Q");
    QTest::keyClick(&fixture.view, Qt::Key_PageUp); // a step of that stage
    QVERIFY2(fixture.value("Q").z > 1000, "a step that can be seen");
  }

  void numbers_hiddenByAQuestion_areNotInThePicture() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const auto hasNumbers = [&] {
      const Figure figure = fixture.view.drawn().pictureContent().figure;
      return std::any_of(figure.marks.begin(), figure.marks.end(),
                         [](const Mark &mark) { return !baseOf(mark).numbers.empty(); });
    };
    QVERIFY(hasNumbers());
    fixture.view.drawn().setNumbersHidden(true);
    QVERIFY(!hasNumbers());
  }

  void sizeScale_makesAllPixelsOfTheDesignLarger() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const double before = fixture.view.screen().designRatio();
    fixture.view.setSizeScale(1.5);
    QCOMPARE(fixture.view.screen().designRatio(), 1.5 * before);
    QVERIFY(seesAllHandles(fixture)); // at home, with room for larger labels
  }
};

QTEST_MAIN(SceneViewCameraTest)
#include "scene_view_camera_test.moc"
