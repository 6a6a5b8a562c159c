// The mouse and the keys over the 3D view: hovering, grabbing, letting go, choosing handles.
#include "tests/widgets/view/view_fixture.h"

#include "lessons/object/kinds/plane.h"

#include <QToolTip>

using namespace halfspace;
using namespace halfspace::test;

namespace {

QString lastOf(const QSignalSpy &spy) { return spy.isEmpty() ? QString() : spy.last().at(0).toString(); }

} // namespace

class SceneViewInputTest : public QObject {
  Q_OBJECT

private slots:
  void pointer_overAHandle_tellsItsMark_andThatItLeaves() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    QSignalSpy hovered(&fixture.view.handles(), &SceneHandles::markHovered);
    movePointer(fixture.view, fixture.at("Q"));
    QCOMPARE(lastOf(hovered), QString("Q"));
    QCOMPARE(fixture.view.cursor().shape(), Qt::OpenHandCursor);
    movePointer(fixture.view, fixture.at("Q") + QPoint(1, 0));
    QCOMPARE(hovered.count(), 1);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&fixture.view, &leave);
    QCOMPARE(lastOf(hovered), QString());
    QVERIFY(fixture.view.cursor().shape() != Qt::OpenHandCursor);
  }

  void click_onAHandle_selectsItAndChangesNothing() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.model.snapping().step = Rational(1, 1000);
    const Session before = fixture.model.session();
    const QPoint at = fixture.at("Q");
    fixture.press(at);
    QVERIFY(fixture.model.history().inGesture());
    movePointer(fixture.view, at + QPoint(2, -1), Qt::LeftButton); // the hand trembles
    fixture.release(at + QPoint(2, -1));
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string("Q"));
    QVERIFY(!fixture.model.history().inGesture());
    QVERIFY(fixture.model.session() == before);
    QCOMPARE(fixture.model.history().count(), 0);
  }

  void selection_whoseHandleGoesInAGesture_isLostAtOnce() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    SceneHandles &handles = fixture.view.handles();
    handles.select("E.offset");
    QCOMPARE(handles.selection().selectedId(), std::string("E.offset"));
    QSignalSpy selected(&handles, &SceneHandles::selectionChanged);
    SessionHistory &history = fixture.model.history();
    const GestureToken held = history.beginGesture("Turn the plane");
    history.moveGesture(held, ChangeObject{"E", PlaneObject{{0, 0, 0}, {3, 2, 1}}});
    QCOMPARE(selected.count(), 0);
    history.moveGesture(held, ChangeObject{"E", PlaneObject{{0, 0, 0}, {0, 0, 0}}}); // along no normal
    QCOMPARE(handles.selection().selectedId(), std::string());
    QCOMPARE(selected.count(), 1);
    history.cancelGesture(held);
  }

  void doubleClick_onAHandle_grabsItLikeAPress() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint at = fixture.at("Q");
    QMouseEvent twice(QEvent::MouseButtonDblClick, at, fixture.view.mapToGlobal(at), Qt::LeftButton,
                      Qt::LeftButton, {});
    QCoreApplication::sendEvent(&fixture.view, &twice);
    QVERIFY(fixture.model.history().inGesture());
    fixture.release(at);
  }

  void drag_whoseReleaseWentElsewhere_endsWithTheNextMove() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint at = fixture.at("Q");
    fixture.press(at);
    movePointer(fixture.view, at + QPoint(60, 30), Qt::LeftButton);
    movePointer(fixture.view, at + QPoint(70, 30)); // with no button down
    QVERIFY(!fixture.model.history().inGesture());
    QCOMPARE(fixture.model.history().count(), 1);
    const ExactVec3 dragged = fixture.value("Q");
    QVERIFY(dragged != ExactVec3(11, 15, 8));
    movePointer(fixture.view, at - QPoint(70, 30));
    QVERIFY(fixture.value("Q") == dragged);
  }

  void manyMoves_beforeAFrame_areOneEvaluation() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint at = fixture.at("Q");
    fixture.model.snapping().step = Rational(1, 1000);
    fixture.press(at);
    QSignalSpy outcomes(&fixture.model, &SessionModel::outcomeChanged);
    for (int x = 0; x <= 100; ++x)
      movePointer(fixture.view, at + QPoint(x, 0), Qt::LeftButton);
    fixture.release(at + QPoint(100, 0));
    QVERIFY2(outcomes.count() <= 2, qPrintable(QString::number(outcomes.count())));
    QVERIFY(fixture.value("Q") != ExactVec3(11, 15, 8));
  }

  void shortcuts_whileAHandleIsHeld_belongToTheDrag() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const auto takesShortcut = [&] {
      QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_X, Qt::NoModifier);
      key.ignore();
      QCoreApplication::sendEvent(&fixture.view, &key);
      return key.isAccepted();
    };
    QVERIFY(!takesShortcut());
    fixture.press(fixture.at("Q"));
    QVERIFY(takesShortcut());
    fixture.release(fixture.at("Q"));
    QVERIFY(!takesShortcut());
  }

  void escape_withNothingHeld_dismissesTheSelection() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.handles().select("Q");
    QSignalSpy dismissed(&fixture.view.input(), &SceneInput::dismissed);
    QTest::keyClick(&fixture.view, Qt::Key_Escape);
    QCOMPARE(dismissed.count(), 1);
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string());
    fixture.press(fixture.at("Q"));
    QTest::keyClick(&fixture.view, Qt::Key_Escape); // this one is for the drag
    QCOMPARE(dismissed.count(), 1);
    fixture.release(fixture.at("Q"));
  }

  void click_besideTheHandles_dismissesTheSelection_butTurningTheViewDoesNot() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.handles().select("Q");
    const QPoint beside(5, 5);
    fixture.dragBeside({40, 10});
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string("Q"));
    fixture.press(beside);
    fixture.release(beside);
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string());
  }

  void tab_behindTheLastHandle_leavesTheView() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.handles().select("Q"); // the last
    QTest::keyClick(&fixture.view, Qt::Key_Tab);
    QCOMPARE(fixture.window.focusWidget(), &fixture.other);
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string());
  }

  void tab_fromNoHandle_beginsAtTheFirst_andBackwardsAtTheLast() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    QTest::keyClick(&fixture.view, Qt::Key_Tab);
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string("E.P0"));
    fixture.view.handles().select({});
    for (const char *id : {"Q", "E.offset"}) {
      QTest::keyClick(&fixture.view, Qt::Key_Backtab, Qt::ShiftModifier);
      QCOMPARE(fixture.view.handles().selection().selectedId(), std::string(id));
    }
  }

  void arrowKeys_onAHandleThatMovesUpAndDown_goAlongZ() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    for (int click = 0; click < 2; ++click)
      QTest::mouseClick(&fixture.view, Qt::LeftButton, {}, fixture.at("Q"));
    QTest::keyClick(&fixture.view, Qt::Key_Up);
    QVERIFY(fixture.value("Q") == ExactVec3(11, 15, 9));
    fixture.view.handles().select("E.P0"); // another handle begins in x and y again
    QTest::keyClick(&fixture.view, Qt::Key_Up);
    QVERIFY(fixture.value("E").z == 7);
    QVERIFY(fixture.value("E") != ExactVec3(5, 4, 7));
  }

  void keys_withNoHandleSelected_moveNothing() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    for (const Qt::Key key : {Qt::Key_Up, Qt::Key_PageUp, Qt::Key_X})
      QTest::keyClick(&fixture.view, key);
    QCOMPARE(fixture.model.history().count(), 0);
  }

  void axisKey_pressedTwiceDuringADrag_locksAndFreesTheAxis() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint at = fixture.at("Q");
    QSignalSpy hints(&fixture.view, &SceneView::hint);
    fixture.press(at);
    const QString free = lastOf(hints);
    QVERIFY2(free.startsWith("Moves in x and y"), qPrintable(free));
    QTest::keyClick(&fixture.view, Qt::Key_X);
    QCOMPARE(lastOf(hints), QString("Moves along x only."));
    movePointer(fixture.view, at + QPoint(0, 80), Qt::LeftButton);
    QTRY_VERIFY(fixture.value("Q").x != 11);
    QVERIFY(fixture.value("Q").y == 15);
    QTest::keyClick(&fixture.view, Qt::Key_X);
    QCOMPARE(lastOf(hints), free);
    fixture.release(at + QPoint(0, 80));
  }

  void shift_pressedAndReleasedDuringADrag_movesUpAndDownMeanwhile() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint at = fixture.at("Q");
    QSignalSpy hints(&fixture.view, &SceneView::hint);
    fixture.press(at);
    QTest::keyPress(&fixture.view, Qt::Key_Shift);
    QVERIFY(lastOf(hints).startsWith("Moves up and down"));
    movePointer(fixture.view, at - QPoint(0, 60), Qt::LeftButton);
    QTRY_VERIFY(fixture.value("Q").z > 8);
    QVERIFY(fixture.value("Q").x == 11 && fixture.value("Q").y == 15);
    QTest::keyRelease(&fixture.view, Qt::Key_Shift);
    QVERIFY(lastOf(hints).startsWith("Moves in x and y"));
    fixture.release(at - QPoint(0, 60));
  }

  void drag_withCtrlOrAltHeld_isNotSnapped() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const auto isOnGrid = [&] { return fixture.value("Q").x.denominator() == 1; };
    for (const Qt::KeyboardModifier held : {Qt::ControlModifier, Qt::AltModifier}) {
      const QPoint at = fixture.at("Q");
      fixture.press(at);
      movePointer(fixture.view, at + QPoint(53, 9), Qt::LeftButton, held);
      QTRY_VERIFY(!isOnGrid());
      movePointer(fixture.view, at + QPoint(53, 9), Qt::LeftButton);
      QTRY_VERIFY(isOnGrid());
      QTest::keyPress(&fixture.view, held == Qt::AltModifier ? Qt::Key_Alt : Qt::Key_Control);
      QTRY_VERIFY(!isOnGrid()); // at the key press, not at the next move
      QTest::keyRelease(&fixture.view, held == Qt::AltModifier ? Qt::Key_Alt : Qt::Key_Control, held);
      QTRY_VERIFY(isOnGrid());
      fixture.release(at + QPoint(53, 9));
      QVERIFY(isOnGrid());
    }
  }

  void drag_withSnappingOff_isNotSnapped_butKeysGoInSteps() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.model.snapping().isOn = false;
    const QPoint at = fixture.at("Q");
    fixture.press(at);
    movePointer(fixture.view, at + QPoint(53, 9), Qt::LeftButton);
    fixture.release(at + QPoint(53, 9));
    const ExactVec3 dragged = fixture.value("Q");
    QVERIFY(dragged.x.denominator() != 1);
    QTest::keyClick(&fixture.view, Qt::Key_PageUp);
    QVERIFY(fixture.value("Q") == dragged + ExactVec3(0, 0, 1));
  }

  void caughtCase_isNotSaidAnyMoreAfterTheRelease() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    QSignalSpy hints(&fixture.view, &SceneView::hint);
    const QPoint at = fixture.at("Q");
    fixture.press(at);
    // At z = 8 the plane's points are x + 2y = 11.
    const glm::dvec2 onPlane(
        *fixture.view.viewpoint().camera().project({3, 4, 8}, fixture.view.screen().size()));
    movePointer(fixture.view, {qRound(onPlane.x), qRound(onPlane.y)}, Qt::LeftButton);
    QTRY_COMPARE(lastOf(hints), QString("plane E"));
    QCOMPARE(QToolTip::text(), QString("plane E"));
    fixture.release({qRound(onPlane.x), qRound(onPlane.y)});
    QVERIFY(lastOf(hints).startsWith("Moves in x and y"));
    QTRY_VERIFY(!QToolTip::isVisible());
  }

  void caughtCase_isSaid_alsoWhereTheGridHadLedThereBefore() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    QSignalSpy hints(&fixture.view, &SceneView::hint);
    fixture.press(fixture.at("Q"));
    const ExactVec3 inPlane(3, 4, 8);
    const glm::dvec2 place(
        *fixture.view.viewpoint().camera().project({3, 4, 8}, fixture.view.screen().size()));
    const QPoint there(qRound(place.x), qRound(place.y));
    bool isBesideIt = false; // on the grid, and too far away to be caught
    for (int away = 5; away < 30 && !isBesideIt; ++away) {
      movePointer(fixture.view, there + QPoint(away, 0), Qt::LeftButton);
      QCoreApplication::processEvents();
      isBesideIt = fixture.value("Q") == inPlane && lastOf(hints) != "plane E";
    }
    QVERIFY(isBesideIt);
    movePointer(fixture.view, there, Qt::LeftButton);
    QTRY_COMPARE(lastOf(hints), QString("plane E"));
    QVERIFY(fixture.value("Q") == inPlane);
    fixture.release(there);
  }

  void history_saysInWordsWhatTheHandDid() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    for (const auto &[id, said] : {std::pair("E.n", "Move the tip of n"), std::pair("E.P0", "Move P₀ of E"),
                                   std::pair("E.offset", "Slide E along its normal")}) {
      const QPoint at = fixture.at(id);
      fixture.press(at);
      movePointer(fixture.view, at + QPoint(0, -60), Qt::LeftButton);
      fixture.release(at + QPoint(0, -60));
      QCOMPARE(fixture.model.history().undoText().value(), std::string(said));
    }
    fixture.view.handles().select("Q");
    QTest::keyClick(&fixture.view, Qt::Key_PageUp);
    QCOMPARE(fixture.model.history().undoText().value(), std::string("Move Q"));
  }

  void note_atATip_tellsTheArrowsOwnNumber() {
    ViewFixture fixture({{planeE(), rayL()}});
    QVERIFY(fixture.ready);
    fixture.view.viewpoint().show(NamedView::Top);
    fixture.view.handles().select("L.r");
    QCOMPARE(fixture.view.handles().gizmo()->note,
             std::string("\\text{$\\displaystyle r_z = 2$ fixed}")); // its height is 10
    fixture.view.handles().select("L.Q");
    QCOMPARE(fixture.view.handles().gizmo()->note, std::string("\\text{$\\displaystyle z = 8$ fixed}"));
  }

  void hint_ofAHandThatHasDragged_saysNoMoreHowToDrag() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    QSignalSpy hints(&fixture.view, &SceneView::hint);
    const auto dragOnce = [&](int way) {
      dragPointer(fixture.view, fixture.at("Q"), fixture.at("Q") + QPoint(way, 0));
      fixture.view.handles().select({});
      return hints.last().front().toString();
    };
    QVERIFY(dragOnce(30).startsWith("Drag a handle"));
    dragOnce(-30);
    QCOMPARE(dragOnce(30), QString());
  }

  void press_thatJustMissesAHandle_takesIt() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const Camera before = fixture.view.viewpoint().camera();
    const ExactVec3 start = fixture.value("Q");
    const double ball = 6; // pixels, at most, of its seen radius
    const QPoint beside = fixture.at("Q") + QPoint(0, -static_cast<int>(ball + missMargin - 2));
    dragPointer(fixture.view, beside, beside + QPoint(60, 20));
    QVERIFY(fixture.value("Q") != start);
    QVERIFY(fixture.view.viewpoint().camera() == before);
  }

  void patch_afterAnEditThatWasTyped_glidesToItsNewSize() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.setMotion(true);
    const Extents before = extentsOf(fixture.view.drawn().drawnFigure());
    fixture.model.history().edit(ChangeObject{"Q", PointObject{{25, 15, 8}}}, "typed");
    QVERIFY2(extentsOf(fixture.view.drawn().drawnFigure()) == before, "it does not leap");
    QTRY_VERIFY(extentsOf(fixture.view.drawn().drawnFigure()) ==
                extentsOf(fixture.view.drawn().pictureContent().figure));
    QVERIFY(extentsOf(fixture.view.drawn().drawnFigure()) != before);
  }

  void others_whileAHandleIsDragged_areDrawnAsFarAsTheyWere() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const auto patchOf = [](const Figure &figure) { return extentsOf(figure).at("E"); };
    const auto must = [&] { return patchOf(fixture.view.drawn().pictureContent().figure); };
    const auto drawn = [&] { return patchOf(fixture.view.drawn().drawnFigure()); };
    const auto before = must();
    const QPoint at = fixture.at("Q");
    fixture.press(at);
    for (const QPoint way : {QPoint(-120, 20), QPoint(100, 60)}) {
      movePointer(fixture.view, at + way, Qt::LeftButton);
      QTRY_VERIFY(must() != before); // the foot lies elsewhere
      QVERIFY(drawn() == before);
    }
    fixture.release(at + QPoint(100, 60));
    QVERIFY(must() != before);
    QVERIFY(drawn() == must()); // without motion it does not glide
  }

  void others_afterADrag_glideToWhereTheyMust() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.setMotion(true);
    const auto drawn = [&] { return extentsOf(fixture.view.drawn().drawnFigure()).at("E"); };
    const auto before = drawn();
    const QPoint at = fixture.at("Q");
    fixture.press(at);
    movePointer(fixture.view, at + QPoint(100, 60), Qt::LeftButton);
    fixture.release(at + QPoint(100, 60));
    const auto must = extentsOf(fixture.view.drawn().pictureContent().figure).at("E");
    QVERIFY(must != before);
    QVERIFY(drawn() == before);
    QTRY_VERIFY(drawn() != before && drawn() != must);
    QTRY_VERIFY(drawn() == must);
  }

  void dragged_itself_isDrawnAsFarAsItMust() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint at = fixture.at("E.P0");
    fixture.press(at);
    movePointer(fixture.view, at + QPoint(-140, -60), Qt::LeftButton);
    QTRY_VERIFY(fixture.value("E") != ExactVec3(5, 4, 7));
    QVERIFY(extentsOf(fixture.view.drawn().drawnFigure()) ==
            extentsOf(fixture.view.drawn().pictureContent().figure));
    fixture.release(at + QPoint(-140, -60));
  }

  void handle_withAnAxisOfItsOwn_isToldToMoveAlongItOnly() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    QSignalSpy hints(&fixture.view, &SceneView::hint);
    const QPoint at = fixture.at("E.offset");
    fixture.press(at);
    QCOMPARE(lastOf(hints), QString("Moves along its line only."));
    QTest::keyClick(&fixture.view, Qt::Key_X); // it has no other
    QCOMPARE(lastOf(hints), QString("Moves along its line only."));
    fixture.release(at);
  }

  void handle_thatCanMoveOneWayOnlyAsItIsSeen_isToldHowToLookForTheOther() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.viewpoint().setOrthographic(true);
    QSignalSpy hints(&fixture.view, &SceneView::hint);
    const auto hintFrom = [&](NamedView view) {
      fixture.view.viewpoint().show(view);
      fixture.view.handles().select("Q");
      QTest::qWait(600); // the camera glides
      fixture.view.handles().select({});
      fixture.view.handles().select("Q");
      return lastOf(hints);
    };
    QVERIFY2(hintFrom(NamedView::Front).contains("Look from higher above"), qPrintable(lastOf(hints)));
    QVERIFY2(hintFrom(NamedView::Top).contains("Look from the side"), qPrintable(lastOf(hints)));
  }

  void selection_ofWhatIsRemoved_isGone() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.handles().select("Q");
    QCOMPARE(fixture.model.history().edit(RemoveEntry{"Q", true}, "remove"), QString());
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string());
    QVERIFY(!handlePosition(fixture.view, "Q"));
  }

  void selection_inAnotherLesson_isGone() {
    ViewFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.handles().select("Q");
    fixture.model.openLesson("lesson1"); // it has a point Q too
    QCOMPARE(fixture.view.handles().selection().selectedId(), std::string());
    QVERIFY(handlePosition(fixture.view, "Q"));
  }
};

QTEST_MAIN(SceneViewInputTest)
#include "scene_view_input_test.moc"
