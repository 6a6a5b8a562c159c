// Objects that slide on others, and corners that come and go, by hand in a real window.
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/app/window_fixture.h"
#include "tests/lessons/objects.h"

#include <QAction>
#include <QSignalSpy>

using namespace halfspace;
using test::polygonOf;
using test::withNumbers;

namespace {

/// A window that shows a scene of its own, all of it in view.
class SceneFixture : public WindowFixture {
public:
  explicit SceneFixture(Scene scene) : WindowFixture("signed-distance") {
    model().startWith({"signed-distance", 0, std::move(scene)});
    window.sceneView().viewpoint().show(NamedView::Fit);
    QTest::qWait(100);
  }

  ExactVec3 placeOf(const std::string &bound) {
    return model().evaluation().find(bound)->looksAt.front()->object[0];
  }
  /// Drags a handle so that what is seen under the pointer follows it to a place.
  void dragTo(const std::string &handle, const Place &place) {
    const QPoint from = *handlePosition(scene(), handle);
    drag(from, pixelOf(place));
  }
  QAction *actionCalled(const QString &text) {
    for (QAction *each : window.findChildren<QAction *>())
      if (each->text().remove('&') == text)
        return each;
    return nullptr;
  }
};

} // namespace

class ObjectsTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void pointOnALine_dragged_slidesOnItInOneUndoStep() {
    SceneFixture fixture(
        {{{"g", LineObject{{0, 0, 2}, {4, 2, 0}}}, {"P", withNumbers("point-on-line", {0}), "g"}}});
    QVERIFY(fixture.ready);
    fixture.dragTo("P", {4, 2, 2});
    QCOMPARE(fixture.scene().handles().selection().selectedId(), std::string("P"));
    QVERIFY(fixture.value("P.lambda").x == 1);
    QVERIFY(fixture.placeOf("P") == ExactVec3(4, 2, 2));
    QCOMPARE(fixture.model().history().count(), 1);
    fixture.model().history().undo();
    QVERIFY(fixture.placeOf("P") == ExactVec3(0, 0, 2));
  }

  void pointInAPlane_dragged_staysInItAndGoesWithIt() {
    SceneFixture fixture(
        {{{"E", PlaneObject{{0, 0, 3}, {1, 2, 4}}}, {"P", *makeObject("point-on-plane"), "E"}}});
    QVERIFY(fixture.ready);
    const auto distance = [&] {
      return dot(fixture.placeOf("P") - fixture.value("E.P0"), fixture.value("E.n"));
    };
    const ExactVec3 before = fixture.placeOf("P");
    fixture.dragTo("P", {2, 1, 2});
    QVERIFY(!(fixture.placeOf("P") == before));
    QVERIFY(distance() == 0);
    QVERIFY(fixture.model()
                .history()
                .edit(ChangeObject{"E", PlaneObject{{0, 0, 3}, {3, -1, 2}}}, "turn")
                .isEmpty());
    QVERIFY(distance() == 0);
  }

  void pointOfATriangle_draggedFarOut_stopsAtItsEdge() {
    SceneFixture fixture({{{"T", TriangleObject{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}},
                           {"P", withNumbers("point-on-triangle", {Rational(1, 4), Rational(1, 4)}), "T"}}});
    QVERIFY(fixture.ready);
    fixture.dragTo("P", {7, 7, 0});
    QVERIFY(fixture.value("P.s").x + fixture.value("P.t").x == 1);
    QVERIFY(fixture.value("P.s").x >= 0 && fixture.value("P.t").x >= 0);
  }

  void pointOfASphere_draggedAside_staysOnIt() {
    Object sphere = *makeObject("sphere");
    sphere[0] = ExactVec3(1, 1, 3);
    sphere[1].x = 3;
    SceneFixture fixture({{{"S", sphere}, {"P", withNumbers("point-on-sphere", {1, -1}), "S"}}});
    QVERIFY(fixture.ready);
    fixture.model().snapping().step = Rational(1, 10);
    const QPoint from = *handlePosition(fixture.scene(), "P");
    const ExactVec3 before = fixture.placeOf("P");
    fixture.drag(from, from + QPoint(40, 25));
    const ExactVec3 way = fixture.placeOf("P") - sphere[0];
    QVERIFY(!(fixture.placeOf("P") == before));
    QVERIFY(dot(way, way) == 9);
    const QPoint now = *handlePosition(fixture.scene(), "P");
    QVERIFY2((now - from - QPoint(40, 25)).manhattanLength() < 30, "it follows the pointer");
  }

  void pointOnALine_withKeys_stepsAlongIt() {
    SceneFixture fixture(
        {{{"g", LineObject{{0, 0, 2}, {4, 2, 0}}}, {"P", withNumbers("point-on-line", {0}), "g"}}});
    QVERIFY(fixture.ready);
    fixture.scene().handles().select("P");
    QTest::keyClick(&fixture.scene(), Qt::Key_Right);
    QVERIFY(fixture.value("P.lambda").x != 0);
    QTest::keyClick(&fixture.scene(), Qt::Key_Left);
    QVERIFY(fixture.value("P.lambda").x == 0);
  }

  void corner_selected_getsAnotherBehindItAndGoesByKeys() {
    SceneFixture fixture({{{"A", polygonOf({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}})}}});
    QVERIFY(fixture.ready);
    QAction *add = fixture.actionCalled("Add a Corner Here");
    QAction *remove = fixture.actionCalled("Remove the Corner");
    QVERIFY(add && remove);
    QVERIFY2(!add->isEnabled() && !remove->isEnabled(), "nothing is selected");
    fixture.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
    QTest::mouseClick(&fixture.scene(), Qt::LeftButton, {}, *handlePosition(fixture.scene(), "A.P1"));
    QVERIFY(add->isEnabled() && remove->isEnabled());
    QTest::keyClick(&fixture.scene(), Qt::Key_Insert);
    const auto polygon = [&]() -> const Object & {
      return *findObject(fixture.model().session().scene, "A");
    };
    QCOMPARE(polygon().size(), std::size_t(5));
    QVERIFY(polygon()[2] == ExactVec3(6, 3, 0));
    QCOMPARE(fixture.scene().handles().selection().selectedId(), std::string("A.P2"));
    QTest::keyClick(&fixture.scene(), Qt::Key_Delete);
    QTest::keyClick(&fixture.scene(), Qt::Key_Delete);
    QCOMPARE(polygon().size(), std::size_t(3));
    fixture.scene().handles().select("A.P1");
    QSignalSpy hints(&fixture.scene(), &SceneView::hint);
    QTest::keyClick(&fixture.scene(), Qt::Key_Delete);
    QCOMPARE(hints.last().first().toString(), QString("It has 3 corners, as few as there can be."));
    QCOMPARE(polygon().size(), std::size_t(3));
    for (int i = 0; i < 3; ++i)
      fixture.model().history().undo();
    QVERIFY(polygon() == polygonOf({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}}));
  }
};

QTEST_MAIN(ObjectsTest)
#include "objects_test.moc"
