// Every handle of every lesson, dragged with the mouse in a real window.
#include "lessons/object/kinds/plane.h"
#include "tests/app/window_fixture.h"
#include "tests/widgets/working/told_latex.h"

#include "lessons/construction/working.h"

#include <glm/geometric.hpp>

using namespace halfspace;

namespace {

/// Where a handle is dragged to: two to the right and one back in its horizontal plane, or one step along its
/// own axis.
ExactVec3 wayOf(const Handle &handle) {
  return handle.motion == Handle::Motion::AlongNormal ? ExactVec3(handle.axis) : ExactVec3(2, -1, 0);
}

std::string coordinatesText(const ExactVec3 &v) {
  return toText(v.x) + "," + toText(v.y) + "," + toText(v.z);
}

/// The positions of the marks that show an object's coordinates must be where the coordinates are.
bool markIsAt(const Figure &figure, const std::string &id, const Place &place) {
  const Mark *mark = findMark(figure, id);
  const auto *point = mark ? std::get_if<PointMark>(mark) : nullptr;
  const auto *arrow = mark ? std::get_if<ArrowMark>(mark) : nullptr;
  return (point && point->at == place) || (arrow && arrow->vector == place);
}

/// Counts how often lines are painted beside a picture of another scene.
class MomentWatch : public QObject {
public:
  explicit MomentWatch(WindowFixture &fixture) : m_fixture(fixture), m_lines(fixture.lines()) {
    m_lines.installEventFilter(this);
    connect(&fixture.scene().drawing(), &SceneDrawing::frameDrawn, this,
            [this] { m_drawn = m_fixture.model().session().scene; });
  }

  bool eventFilter(QObject *watched, QEvent *event) override {
    if (event->type() == QEvent::Paint) {
      ++paintings;
      const Scene &now = m_fixture.model().session().scene;
      const auto &firstLine = m_fixture.model().shown().working.lines[0];
      const bool sameLines = latexIn(m_lines).contains(QString::fromStdString(latexOf(firstLine)));
      mixtures += !m_drawn || !(*m_drawn == now) || !sameLines;
    }
    return QObject::eventFilter(watched, event);
  }

  int paintings = 0;
  int mixtures = 0;

private:
  WindowFixture &m_fixture;
  WorkingBlock &m_lines;
  std::optional<Scene> m_drawn; ///< what the picture shows
};

bool standsOnTheGrid(const Object &object) {
  for (std::size_t i = 0; i < object.size(); ++i)
    for (const Rational &number : {object[i].x, object[i].y, object[i].z})
      if (number.denominator() != 1)
        return false;
  return true;
}

/// Whether an object stands on the grid and has the places of its handles for its coordinates; bound ones
/// have freedoms, spheres a length, and two vectors may start at one point.
bool goesByTheGrid(const Object &object) {
  const std::set<std::string_view> kinds{"point", "plane", "ray", "line", "triangle", "polygon"};
  return kinds.contains(kindOf(object)) && standsOnTheGrid(object);
}

} // namespace

class DragTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void handle_draggedToAGridPlace_hasExactlyItsNumbersInOneUndoStep_data() {
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("handleId");
    for (const Lesson &lesson : readLessons(TEST_LESSONS_FOLDER).lessons)
      for (const Handle &handle : handlesOf(lesson.scene))
        if (goesByTheGrid(*findObject(lesson.scene, handle.object)))
          QTest::newRow((lesson.id + " " + handle.id).c_str())
              << QString::fromStdString(lesson.id) << QString::fromStdString(handle.id);
  }

  void handle_draggedToAGridPlace_hasExactlyItsNumbersInOneUndoStep() {
    QFETCH(QString, lesson);
    QFETCH(QString, handleId);
    WindowFixture fixture(lesson.toStdString());
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const auto handles = handlesOf(before.scene);
    const auto handle = std::find_if(handles.begin(), handles.end(),
                                     [&](const Handle &h) { return h.id == handleId.toStdString(); });
    const auto from = handlePosition(fixture.scene(), handle->id);
    QVERIFY(from);
    const ExactVec3 target = handle->at + wayOf(*handle);
    const Object expected = movedTo(*findObject(before.scene, handle->object), *handle, target);

    fixture.drag(*from, *from + fixture.pixelOf(shownPlace(*handle) + toDouble(wayOf(*handle))) -
                            fixture.pixelOf(shownPlace(*handle)));

    QCOMPARE(fixture.scene().handles().selection().selectedId(), handle->id);
    const Scene &after = fixture.model().session().scene;
    for (std::size_t i = 0; i < coordinatesOf(expected).size(); ++i) {
      const ExactVec3 &reached = coordinate(*findObject(after, handle->object), i);
      const ExactVec3 &wanted = coordinate(expected, i);
      QVERIFY2(reached == wanted,
               (coordinatesText(reached) + " instead of " + coordinatesText(wanted)).c_str());
    }
    QCOMPARE(fixture.model().history().count(), 1);
    const auto &specs = coordinatesOf(expected);
    for (std::size_t i = 0; i < specs.size(); ++i)
      QVERIFY2(markIsAt(fixture.model().figure(), fullName(after, {handle->object, i}),
                        toDouble(coordinate(expected, i))),
               std::string(specs[i].name).c_str());

    fixture.model().history().undo();
    QVERIFY(fixture.model().session().scene == before.scene);
    fixture.model().history().redo();
    QVERIFY(*findObject(fixture.model().session().scene, handle->object) == expected);
  }

  void linesAndPicture_whateverMovesTheScene_areSeenOfOneMoment() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.goToLine("f");
    MomentWatch watch(fixture);
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    for (const QPoint way : {QPoint(60, 30), QPoint(-40, 20), QPoint(0, 0)})
      fixture.moveTo(from + way);
    fixture.release();
    for (int z = 0; z < 20; ++z) { // typed: no frame of the view's own comes first
      const Object *point = findObject(fixture.model().session().scene, "Q");
      Object moved = *point;
      coordinate(moved, 0).z = z;
      fixture.model().history().edit(ChangeObject{"Q", moved}, "move Q");
      QTest::qWait(z % 7);
    }
    QTest::qWait(50);
    QVERIFY2(watch.paintings > 15, qPrintable(QString::number(watch.paintings)));
    QCOMPARE(watch.mixtures, 0);
  }

  void escape_duringADrag_restoresWhatWasThere() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    fixture.moveTo(from + QPoint(60, 30));
    QVERIFY(!(fixture.model().session() == before));
    QTest::keyClick(&fixture.scene(), Qt::Key_Escape);
    QVERIFY(fixture.model().session() == before);
    fixture.release();
    QVERIFY(fixture.model().session() == before);
    QCOMPARE(fixture.model().history().count(), 0);
  }

  void edit_fromElsewhereDuringADrag_endsTheDragAsAStepOfItsOwn() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    fixture.moveTo(from + QPoint(60, 30));
    const ExactVec3 dragged = fixture.value("Q");
    QVERIFY(fixture.model().history().inGesture());
    QCOMPARE(fixture.model().history().edit(ChangeObject{"E", PlaneObject{{5, 4, 7}, {0, 0, 1}}}, "typed"),
             QString());
    QVERIFY(!fixture.model().history().inGesture());
    fixture.moveTo(from + QPoint(-60, 30)); // the hand goes on, and holds nothing
    fixture.release();
    QVERIFY(fixture.value("Q") == dragged);
    QCOMPARE(fixture.model().history().count(), 2);
    fixture.model().history().undo();
    QVERIFY(fixture.value("Q") == dragged);
    QVERIFY(fixture.value("E.n") == ExactVec3(1, 2, 2));
    fixture.model().history().undo();
    QVERIFY(fixture.model().session().scene == before.scene);
  }

  void undo_duringADrag_takesBackTheDragAlone() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QCOMPARE(fixture.model().history().edit(ChangeObject{"E", PlaneObject{{5, 4, 7}, {0, 0, 1}}}, "typed"),
             QString());
    const Session before = fixture.model().session();
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    fixture.moveTo(from + QPoint(60, 30));
    const ExactVec3 dragged = fixture.value("Q");
    fixture.model().history().undo();
    QVERIFY(fixture.model().session().scene == before.scene);
    fixture.release();
    fixture.model().history().redo();
    QVERIFY(fixture.value("Q") == dragged);
  }

  void otherButton_releasedDuringADrag_doesNotEndIt() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    fixture.moveTo(from + QPoint(40, 20));
    QTest::mousePress(&fixture.scene(), Qt::RightButton, {}, from + QPoint(40, 20));
    QTest::mouseRelease(&fixture.scene(), Qt::RightButton, {}, from + QPoint(40, 20));
    QVERIFY(fixture.model().history().inGesture());
    const ExactVec3 halfway = fixture.value("Q");
    fixture.moveTo(from + QPoint(90, 45));
    QVERIFY(fixture.value("Q") != halfway);
    fixture.release();
    QVERIFY(!fixture.model().history().inGesture());
    QCOMPARE(fixture.model().history().count(), 1);
  }

  void refusedEdit_saysWhy_andChangesNothing() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    QVERIFY(fixture.model().history().edit(RemoveEntry{"E"}, "remove").contains("distance"));
    QVERIFY(fixture.model().session() == before);
    QCOMPARE(fixture.model().history().count(), 0);
    QCOMPARE(fixture.model().history().edit(RemoveEntry{"E", true}, "remove"), QString());
    QCOMPARE(fixture.model().session().scene.entries.size(), std::size_t(1));
    fixture.model().history().undo();
    QVERIFY(fixture.model().session().scene == before.scene);
  }

  void arrow_isGrabbedAnywhereOnItsHead() {
    WindowFixture fixture("plane-implicit");
    QVERIFY(fixture.ready);
    const QPoint tip = *handlePosition(fixture.scene(), "E.n");
    const QPointF back = fixture.pixelOf(Place(5, 4, 7)) - tip;
    const QPoint onHead = tip + (back * (18 / std::hypot(back.x(), back.y()))).toPoint();
    fixture.drag(onHead, onHead + QPoint(40, 0));
    QVERIFY(fixture.value("E.n") != ExactVec3(1, 2, 2));
  }

  void shift_heldDuringADrag_movesUpAndDownOnly() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from, Qt::ShiftModifier);
    fixture.moveTo(fixture.pixelOf({11, 15, 10}), Qt::ShiftModifier);
    fixture.release(Qt::ShiftModifier);
    QVERIFY(fixture.value("Q") == ExactVec3(11, 15, 10));
  }

  void selectedHandle_clickedAgain_movesUpAndDown() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const QPoint at = *handlePosition(fixture.scene(), "Q");
    for (int click = 0; click < 2; ++click) {
      fixture.press(at);
      fixture.release();
    }
    fixture.drag(at, fixture.pixelOf({11, 15, 6}));
    QVERIFY(fixture.value("Q") == ExactVec3(11, 15, 6));
    QCOMPARE(fixture.model().history().count(), 1);
  }

  void axisKey_pressedDuringADrag_locksTheAxisAtOnce() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    fixture.moveTo(from + QPoint(5, 0));
    QTest::keyClick(&fixture.scene(), Qt::Key_Y);
    fixture.moveTo(from + QPoint(-90, 40));
    fixture.release();
    QVERIFY(fixture.value("Q").x == 11);
    QVERIFY(fixture.value("Q").z == 8);
    QVERIFY(fixture.value("Q").y < 15);
  }

  void gizmoArrow_dragged_movesAlongItsAxisOnly() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.scene().handles().select("Q");
    const Place q(11, 15, 8);
    // Half-way along the arrow of z, which has the same length on every screen.
    const double unitsPerPixel =
        fixture.scene().viewpoint().camera().unitsPerPixel(q, fixture.scene().screen().size());
    const QPoint grip = fixture.pixelOf(q + Place(0, 0, 50 * unitsPerPixel));
    const QPoint way = fixture.pixelOf(q + Place(0, 0, 3)) - fixture.pixelOf(q);
    fixture.drag(grip, grip + way);
    QVERIFY(fixture.value("Q") == ExactVec3(11, 15, 11));
  }

  void arrowKeys_stepTheSelectedHandle_oneUndoStepEach() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.scene().handles().select("Q");
    QTest::keyClick(&fixture.scene(), Qt::Key_PageUp);
    QVERIFY(fixture.value("Q") == ExactVec3(11, 15, 9));
    QTest::keyClick(&fixture.scene(), Qt::Key_Right);
    QVERIFY(fixture.value("Q") == ExactVec3(11, 16, 9));
    QTest::keyClick(&fixture.scene(), Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(fixture.value("Q") == ExactVec3(Rational(111, 10), 16, 9));
    QCOMPARE(fixture.model().history().count(), 3);
    fixture.model().history().undo();
    QVERIFY(fixture.value("Q") == ExactVec3(11, 16, 9));
  }

  void tab_fromHandleToHandle_selectsEachInOrder() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    std::vector<std::string> seen;
    for (int i = 0; i < 4; ++i) {
      QTest::keyClick(&fixture.scene(), Qt::Key_Tab);
      seen.push_back(fixture.scene().handles().selection().selectedId());
    }
    QVERIFY((seen == std::vector<std::string>{"E.P0", "E.n", "E.offset", "Q"}));
  }

  void dragBesideTheHandles_turnsTheCamera_andLeavesTheScene() {
    WindowFixture fixture("plane-implicit");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const double azimuth = fixture.scene().viewpoint().camera().azimuth;
    fixture.drag({8, 8}, {90, 40});
    QVERIFY(fixture.scene().viewpoint().camera().azimuth != azimuth);
    QVERIFY(fixture.model().session() == before);
  }

  void degenerateTriangle_draggedBack_isATriangleAgain() {
    WindowFixture fixture("ray-triangle-perp");
    QVERIFY(fixture.ready);
    const std::string start = fixture.caseName();
    Object triangle = *findObject(fixture.model().session().scene, "T");
    coordinate(triangle, 1) = coordinate(triangle, 0);
    fixture.model().history().edit(ChangeObject{"T", triangle}, "coincide");
    QCOMPARE(fixture.caseName(), std::string("coincident"));
    fixture.model().history().undo();
    QCOMPARE(fixture.caseName(), start);
  }
};

QTEST_MAIN(DragTest)
#include "drag_test.moc"
