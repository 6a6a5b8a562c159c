// Tools that make objects with the mouse and the keys over the 3D view.
#include "tests/picture/hand/tool_scenes.h"
#include "tests/widgets/view/view_fixture.h"
#include "widgets/view/object_tool_words.h"
#include "widgets/view/pointer_hint.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Scene twoPoints() { return typedScene({"A = (4, 0, 0)", "B = (0, 6, 3)", "E: z = 5"}); }

/// A view with a tool in the hand.
struct Making : ViewFixture {
  explicit Making(ToolObject object, const Scene &scene = twoPoints()) : ViewFixture(scene) {
    view.objectHand().begin(object);
  }

  /// The place of the view where a place of the scene is seen.
  QPoint seen(const Place &place) {
    const auto pixel = view.viewpoint().camera().project(place, view.screen().size()).value();
    return {qRound(pixel.x / view.devicePixelRatioF()), qRound(pixel.y / view.devicePixelRatioF())};
  }
  void pointAt(const Place &place, Qt::KeyboardModifiers modifiers = {}) {
    movePointer(view, seen(place), Qt::NoButton, modifiers);
  }
  void click(const Place &place, Qt::MouseButton button = Qt::LeftButton) {
    pointAt(place);
    QTest::mouseClick(&view, button, {}, seen(place));
  }
  void key(Qt::Key key) { QTest::keyClick(&view, key); }
  bool hasTool() { return view.objectHand().tool().has_value(); }
  /// What has come to the scene, as it would be typed.
  std::vector<std::string> added() {
    std::vector<std::string> lines =
        linesOf({model.session().scene.entries.begin(), model.session().scene.entries.end()});
    lines.erase(lines.begin(), lines.begin() + 3);
    return lines;
  }
  bool isGhostDrawn(const std::string &mark) {
    const SceneContent drawn = view.drawn().drawnContent();
    const Mark *found = findMark(drawn.figure, mark);
    return found && baseOf(*found).role == Role::Ghost;
  }
};

using Lines = std::vector<std::string>;

} // namespace

class ObjectHandTest : public QObject {
  Q_OBJECT

private slots:
  void threeClicks_onTheGround_makeATriangle_inOneStep() {
    Making making(ToolObject::Triangle);
    QVERIFY(making.ready);
    QSignalSpy changed(&making.view.objectHand(), &ObjectHand::toolChanged);
    making.click({1, 1, 0});
    making.click({5, 2, 0});
    QVERIFY(making.added().empty());
    making.click({2, 6, 0});
    QVERIFY(making.added() ==
            Lines({"C = (1, 1, 0)", "D = (5, 2, 0)", "P = (2, 6, 0)", "T = triangle(C, D, P)"}));
    QVERIFY(!making.hasTool());
    QCOMPARE(changed.count(), 1);
    QCOMPARE(making.model.history().count(), 1);
    QCOMPARE(making.model.history().undoText().value(), std::string("Add T"));
    making.model.history().undo();
    QVERIFY(making.added().empty());
    making.model.history().redo();
    QCOMPARE(making.added().size(), std::size_t(4));
  }

  void clicks_onPointsOfTheScene_takeThese() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    making.click({4, 0, 0});
    making.click({0, 6, 3});
    QVERIFY(making.added() == Lines({"s = segment(A, B)"}));
  }

  void triangle_thatWasMade_followsItsCornersInADrag() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    making.click({4, 0, 0});
    making.click({0, 6, 3});
    dragPointer(making.view, making.at("A"), making.at("A") + QPoint(60, 10));
    QVERIFY(making.value("A") != ExactVec3(4, 0, 0));
    QVERIFY(making.model.evaluation().find("s")->offers.front().given->object[0] == making.value("A"));
  }

  void ghost_followsThePointer_andIsInNoOtherPicture() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    making.pointAt({1, 1, 0});
    QVERIFY(making.isGhostDrawn("C"));
    QVERIFY(!findMark(making.view.drawn().pictureContent().figure, "C"));
    making.click({1, 1, 0});
    making.pointAt({5, 2, 0});
    QVERIFY(making.isGhostDrawn("s"));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&making.view, &leave);
    QVERIFY(!making.isGhostDrawn("s"));
    QVERIFY(making.isGhostDrawn("C")); // it is taken
    making.view.objectHand().cancel();
    QVERIFY(!making.isGhostDrawn("C"));
  }

  void escape_goesOneStepBack_thenPutsTheToolAway() {
    Making making(ToolObject::Triangle);
    QVERIFY(making.ready);
    QSignalSpy hints(&making.view, &SceneView::hint);
    making.click({1, 1, 0});
    QCOMPARE(hints.last().front().toString(), QString("Click the second corner."));
    making.key(Qt::Key_Escape);
    QCOMPARE(hints.last().front().toString(),
             QString("Click the first corner, or an empty place for a new point."));
    for (const Place &corner : {Place(5, 2, 0), Place(2, 6, 0), Place(1, 1, 0)})
      making.click(corner);
    QCOMPARE(making.added().front(), std::string("C = (5, 2, 0)"));
    making.view.objectHand().begin(ToolObject::Triangle);
    making.key(Qt::Key_Escape);
    QVERIFY(!making.hasTool());
    QVERIFY(hints.last().front().toString().startsWith("Drag a handle"));
  }

  void rightButton_clicked_goesOneStepBack_butDraggedItMovesThePicture() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    making.click({1, 1, 0});
    const Camera before = making.view.viewpoint().camera();
    making.dragBeside({40, 10}, Qt::RightButton);
    QVERIFY(making.view.viewpoint().camera() != before);
    making.pointAt({5, 2, 0});
    QVERIFY(making.isGhostDrawn("s"));
    making.click({5, 2, 0}, Qt::RightButton);
    QVERIFY(!making.isGhostDrawn("s"));
    making.click({5, 2, 0}, Qt::RightButton);
    QVERIFY(!making.hasTool());
  }

  void drag_thatBeginsOnAHandle_turnsThePicture_andTakesNothing() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    const Camera before = making.view.viewpoint().camera();
    dragPointer(making.view, making.seen({4, 0, 0}), making.seen({4, 0, 0}) + QPoint(60, 10));
    QVERIFY(making.view.viewpoint().camera() != before);
    QVERIFY(making.value("A") == ExactVec3(4, 0, 0));
    QVERIFY(making.view.handles().selection().selectedId().empty());
    making.click({0, 6, 3});
    making.click({4, 0, 0});
    QVERIFY(making.added() == Lines({"s = segment(B, A)"}));
    making.press(making.at("A"));
    QVERIFY2(making.model.history().inGesture(), "with the hand empty handles are grabbed again");
    making.release(making.at("A"));
  }

  void enter_behindTheLastCorner_closesThePolygon() {
    Making making(ToolObject::Polygon);
    QVERIFY(making.ready);
    for (const Place &corner : {Place(1, 1, 0), Place(5, 2, 0), Place(2, 6, 0)})
      making.click(corner);
    QVERIFY(making.added().empty());
    making.key(Qt::Key_Return);
    QCOMPARE(making.added().back(), std::string("p = polygon(C, D, P)"));
  }

  void arrowKeysAndEnter_makeAPoint() {
    Making making(ToolObject::Point);
    QVERIFY(making.ready);
    making.view.viewpoint().show(NamedView::Top);
    making.key(Qt::Key_PageUp);
    making.key(Qt::Key_PageUp);
    QVERIFY(making.isGhostDrawn("C"));
    making.key(Qt::Key_Return);
    QVERIFY(making.added() == Lines({"C = (0, 0, 2)"}));
  }

  void pointTool_onAPointThatIsThere_makesNothing_andIsPutAway() {
    Making making(ToolObject::Point);
    QVERIFY(making.ready);
    const Scene before = making.model.session().scene;
    making.click(toDouble(making.value("A")));
    QVERIFY(making.model.session().scene == before);
    QVERIFY(!making.view.objectHand().tool());
  }

  void shift_liftsAPointFromTheGround() {
    Making making(ToolObject::Point);
    QVERIFY(making.ready);
    making.pointAt({1, 1, 0});
    QTest::keyPress(&making.view, Qt::Key_Shift);
    making.pointAt({1, 1, 4}, Qt::ShiftModifier);
    QTest::mouseClick(&making.view, Qt::LeftButton, Qt::ShiftModifier, making.seen({1, 1, 4}));
    QTest::keyRelease(&making.view, Qt::Key_Shift);
    QVERIFY(making.added() == Lines({"C = (1, 1, 4)"}));
  }

  void ctrl_suspendsSnapping() {
    Making making(ToolObject::Point);
    QVERIFY(making.ready);
    making.model.snapping().step = 5;
    making.pointAt({2, 2, 0}, Qt::ControlModifier);
    QTest::mouseClick(&making.view, Qt::LeftButton, Qt::ControlModifier, making.seen({2, 2, 0}));
    const ExactVec3 point = making.value("C");
    QVERIFY(abs(Rational(point.x - 2)) < q(1, 10));
    QVERIFY(abs(Rational(point.y - 2)) < q(1, 10));
  }

  void sphere_isMadeOfItsCentreAndHowFarItReaches() {
    Making making(ToolObject::Sphere);
    QVERIFY(making.ready);
    making.click({4, 0, 0});
    making.pointAt({4, 3, 0});
    QVERIFY(making.isGhostDrawn("S"));
    making.click({4, 3, 0});
    QVERIFY(making.added() == Lines({"k = 3, 0 <= k <= 10, step 1/10", "S = sphere(A, k)"}));
  }

  void pointOn_anObject_isBoundToIt_andTheMarkUnderThePointerStandsOut() {
    Making making(ToolObject::PointOn);
    QVERIFY(making.ready);
    QSignalSpy hovered(&making.view.handles(), &SceneHandles::markHovered);
    making.pointAt({-2, 2, 5});
    QCOMPARE(hovered.last().front().toString(), QString("E"));
    making.click({-2, 2, 5});
    QVERIFY(making.added() == Lines({"C = point-on-plane(E, (-2, 2, 5))"}));
    QCOMPARE(hovered.last().front().toString(), QString());
  }

  void words_besideThePointer_sayWhatIsWanted() {
    Making making(ToolObject::PlaneWithNormal);
    QVERIFY(making.ready);
    const auto *words = making.view.findChild<PointerHint *>();
    QVERIFY(!words->isVisible());
    making.pointAt({1, 1, 0});
    QVERIFY(words->isVisible());
    QCOMPARE(words->text(), QString("Click a point of the plane, or an empty place for a new point."));
    making.click({1, 1, 0});
    QCOMPARE(words->text(), QString("Click the tip of its normal."));
    making.view.viewpoint().show(NamedView::Top);
    making.pointAt({3, 3, 0});
    QCOMPARE(words->text(), endOnPrompt());
    making.view.objectHand().cancel();
    QVERIFY(!words->isVisible());
  }

  void words_atTheEdgeOfTheView_stayWithinIt() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    const QRect view = making.view.rect();
    const auto *words = making.view.findChild<PointerHint *>();
    for (const QPoint &corner : {view.topLeft(), view.topRight(), view.bottomLeft(), view.bottomRight()}) {
      movePointer(making.view, corner);
      QVERIFY(view.contains(words->geometry()));
      QVERIFY(!words->geometry().contains(corner));
    }
  }

  void tool_whosePointIsTakenAway_isPutAway() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    making.click({4, 0, 0});
    making.model.history().edit(ChangeObject{"B", PointObject{{1, 6, 3}}}, "typed");
    QVERIFY(making.hasTool());
    making.model.history().edit(RemoveEntry{"A"}, "removed");
    QVERIFY(!making.hasTool());
    QVERIFY(!making.isGhostDrawn("s"));
  }

  void tool_inAnotherLesson_isPutAway() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    making.click({4, 0, 0});
    making.model.openLesson("lesson1");
    QVERIFY(!making.hasTool());
  }

  void keysOfTheTool_goBeforeShortcuts() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    const auto takesShortcut = [&](int key) {
      QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier);
      event.ignore();
      QCoreApplication::sendEvent(&making.view, &event);
      return event.isAccepted();
    };
    QVERIFY(takesShortcut(Qt::Key_Escape));
    QVERIFY(!takesShortcut(Qt::Key_6));
    making.view.objectHand().cancel();
    QVERIFY(!takesShortcut(Qt::Key_Escape));
  }

  void tab_withAToolInTheHand_leavesTheView() {
    Making making(ToolObject::Segment);
    QVERIFY(making.ready);
    making.key(Qt::Key_Tab);
    QCOMPARE(making.window.focusWidget(), &making.other);
    QVERIFY(making.view.handles().selection().selectedId().empty());
  }

  void everyTool_hasWordsForEachOfItsSteps() {
    for (const ObjectToolWords &words : objectTools()) {
      QVERIFY2(!words.id.isEmpty() && !words.title.isEmpty() && !words.description.isEmpty(),
               qPrintable(words.id));
      ObjectTool tool{words.object};
      QSet<QString> prompts;
      for (int i = 0; wishOf(tool) && i < 3; ++i) {
        prompts.insert(promptOf(tool));
        ToolPick point = newPoint(tool, {}, ExactVec3(i, i * i, 0));
        tool = withPick(tool, point);
      }
      QVERIFY2(!prompts.contains(QString()), qPrintable(words.id));
      QCOMPARE(prompts.size(), static_cast<int>(tool.picks.size()));
      QCOMPARE(promptOf(tool).isEmpty(), !wishOf(tool).has_value());
    }
    QCOMPARE(objectTools().size(), std::size_t(14));
  }
};

QTEST_MAIN(ObjectHandTest)
#include "object_hand_test.moc"
