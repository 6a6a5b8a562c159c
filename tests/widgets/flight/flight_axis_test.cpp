// The axis of the ray's parameter under the pointer and the keys.
#include "widgets/flight/flight_axis.h"

#include "tests/widgets/flight/some_crossings.h"
#include "tests/widgets/pointer.h"

#include <QAccessible>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// Takes the torpedo where it is dragged, as the window does.
struct ShownAxis {
  explicit ShownAxis(const Typesetter &typesetter, int width = 430) : axis(typesetter) {
    QObject::connect(&axis, &FlightAxis::scrubbed, [this](double t) {
      scrubbed.push_back(t);
      axis.setTime(t, t);
    });
    QObject::connect(&axis, &FlightAxis::scrubBegun, [this] { ++begun; });
    QObject::connect(&axis, &FlightAxis::scrubEnded, [this](bool keep) {
      ++ended;
      kept = keep;
    });
    QObject::connect(&axis, &FlightAxis::chosen, [this](std::size_t number) { chosen.push_back(number); });
    QObject::connect(&axis, &FlightAxis::hovered, [this](std::size_t number) { hovered.push_back(number); });
    axis.resize(width, axis.sizeHint().height());
    axis.setCrossings(someCrossings());
  }
  [[nodiscard]] QPoint onLine(double t) const {
    return QPointF(axis.placed().scale().xOf(t), axis.placed().handle().y()).toPoint();
  }

  FlightAxis axis;
  std::vector<double> scrubbed;
  std::vector<std::size_t> chosen;
  std::vector<std::size_t> hovered;
  int begun = 0;
  int ended = 0;
  bool kept = false; ///< what was scrubbed last
};

using Numbers = std::vector<std::size_t>;

} // namespace

class FlightAxisTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void drag_alongTheAxis_tellsTheTimesInOrder_andEndsOnce() {
    ShownAxis shown(m_typesetter);
    const QPoint from = shown.onLine(0) - QPoint(4, 0); // on the torpedo
    QTest::mousePress(&shown.axis, Qt::LeftButton, {}, from);
    QCOMPARE(shown.begun, 0);
    for (int x = 1; x < 600; x += 3)
      movePointer(shown.axis, from + QPoint(x, 0), Qt::LeftButton);
    QVERIFY(shown.axis.isScrubbing());
    QTest::mouseRelease(&shown.axis, Qt::LeftButton, {}, from + QPoint(600, 0));
    QCOMPARE(shown.begun, 1);
    QCOMPARE(shown.ended, 1);
    QVERIFY(std::is_sorted(shown.scrubbed.begin(), shown.scrubbed.end()));
    QCOMPARE(shown.scrubbed.back(), 2.0); // the axis' end
  }

  void drag_ofTheTorpedo_keepsWhereItWasGrabbed() {
    ShownAxis shown(m_typesetter);
    const QPoint from = shown.onLine(0) - QPoint(9, 2);
    QTest::mousePress(&shown.axis, Qt::LeftButton, {}, from);
    movePointer(shown.axis, from + QPoint(30, 0), Qt::LeftButton, Qt::AltModifier);
    QVERIFY(std::abs(shown.axis.placed().scale().xOf(shown.scrubbed.back()) -
                     shown.axis.placed().scale().xOf(0) - 30) < 1e-9);
    QTest::mouseRelease(&shown.axis, Qt::LeftButton);
  }

  void drag_closeToAHit_catchesIt() {
    ShownAxis shown(m_typesetter);
    QTest::mousePress(&shown.axis, Qt::LeftButton, {}, shown.onLine(0.5) + QPoint(2, 0));
    QCOMPARE(shown.scrubbed.back(), 0.5);
    QTest::mouseRelease(&shown.axis, Qt::LeftButton, {}, shown.onLine(0.5) + QPoint(2, 0));
  }

  void escape_inADrag_goesBackToWhereItBegan() {
    ShownAxis shown(m_typesetter);
    shown.axis.setTime(0.25, 0.25);
    const QPoint from = shown.onLine(0.25) - QPoint(4, 0);
    QTest::mousePress(&shown.axis, Qt::LeftButton, {}, from);
    movePointer(shown.axis, from + QPoint(80, 0), Qt::LeftButton);
    QTest::keyClick(&shown.axis, Qt::Key_Escape);
    QCOMPARE(shown.ended, 1);
    QVERIFY(!shown.kept);
    QVERIFY(!shown.axis.isScrubbing());
  }

  void range_whileHeldOrScrubbed_stays() {
    ShownAxis shown(m_typesetter);
    const AxisRange before = shown.axis.placed().scale().range;
    Crossings far = someCrossings();
    far.all[3].at->t = 9;
    shown.axis.setHeld(true);
    shown.axis.setCrossings(far);
    shown.axis.setTime(30, 30);
    QVERIFY(shown.axis.placed().scale().range == before);
    QVERIFY(shown.axis.placed().handle().x() <= shown.axis.placed().scale().right);
    shown.axis.setHeld(false);
    QVERIFY(shown.axis.placed().scale().range.contains(9) && shown.axis.placed().scale().range.contains(30));
    shown.axis.setTime(0, 0);
    const AxisRange settled = shown.axis.placed().scale().range;
    QTest::mousePress(&shown.axis, Qt::LeftButton, {}, shown.onLine(1));
    shown.axis.setCrossings(someCrossings());
    QVERIFY(shown.axis.placed().scale().range == settled);
    QTest::mouseRelease(&shown.axis, Qt::LeftButton, {}, shown.onLine(1));
    QVERIFY(shown.axis.placed().scale().range == before);
  }

  void marks_atTheSamePlace_areStacked_andEachIsFound() {
    ShownAxis shown(m_typesetter);
    const QPointF first = *shown.axis.placed().placeOf(1);
    const QPointF second = *shown.axis.placed().placeOf(5);
    QCOMPARE(first.x(), second.x());
    QVERIFY(first.y() - second.y() >= 9);
    QVERIFY(first.y() < shown.axis.placed().handle().y());
    for (const QPointF &place : {first, second})
      QTest::mouseClick(&shown.axis, Qt::LeftButton, {}, place.toPoint());
    QCOMPARE(shown.chosen, (Numbers{1, 5}));
    QCOMPARE(shown.begun, 0);
  }

  void marks_ofVeryManyAtTheSamePlace_stayInTheWidget() {
    ShownAxis shown(m_typesetter);
    Crossings crossings;
    for (std::size_t i = 1; i <= 30; ++i)
      crossings.all.push_back(crossingAt(i, RayTriangleCase::Hit, 1));
    shown.axis.setCrossings(crossings);
    for (std::size_t i = 1; i <= 30; ++i)
      QVERIFY(shown.axis.placed().placeOf(i)->y() > 4);
  }

  void mark_beyondTheRange_isAtItsEnd() {
    ShownAxis shown(m_typesetter);
    Crossings far = someCrossings();
    far.all[4].at->t = 1000;
    shown.axis.setCrossings(far);
    QVERIFY(shown.axis.placed().placeOf(6)->x() > shown.axis.placed().scale().right);
    QVERIFY(shown.axis.placed().placeOf(6)->x() < shown.axis.width());
    QVERIFY(!shown.axis.placed().placeOf(2)); // parallel
  }

  void pointer_onAMark_tellsItsFragment() {
    ShownAxis shown(m_typesetter);
    movePointer(shown.axis, shown.axis.placed().placeOf(3)->toPoint());
    movePointer(shown.axis, {2, 2});
    QCOMPARE(shown.hovered, (Numbers{3, 0}));
  }

  void keys_moveByTenthsOfATick_andToTheStart() {
    ShownAxis shown(m_typesetter);
    QTest::keyClick(&shown.axis, Qt::Key_Right);
    const double step = shown.scrubbed.back();
    QVERIFY(step > 0 && step < 0.2);
    QTest::keyClick(&shown.axis, Qt::Key_Right);
    QVERIFY(std::abs(shown.scrubbed.back() - 2 * step) < 1e-12);
    QTest::keyClick(&shown.axis, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(std::abs(shown.scrubbed.back() - 1.9 * step) < 1e-12);
    QTest::keyClick(&shown.axis, Qt::Key_Home);
    QCOMPARE(shown.scrubbed.back(), 0.0);
    QCOMPARE(shown.begun, 4);
    QCOMPARE(shown.ended, 4);
  }

  void keys_upAndDown_chooseTheCrossingsInTheirOrder() {
    ShownAxis shown(m_typesetter);
    QTest::keyClick(&shown.axis, Qt::Key_Up);
    QTest::keyClick(&shown.axis, Qt::Key_Down);
    QCOMPARE(shown.chosen, (Numbers{4, 6})); // of those with a place the first and the last
    for (const std::size_t chosen : Numbers{4, 3, 6}) {
      Crossings crossings = someCrossings();
      crossings.chosen = chosen;
      shown.axis.setCrossings(crossings);
      QTest::keyClick(&shown.axis, Qt::Key_Up);
      QTest::keyClick(&shown.axis, Qt::Key_Down);
    }
    QCOMPARE(shown.chosen, (Numbers{4, 6, 3, 4, 1, 4, 6, 5}));
    QVERIFY(shown.scrubbed.empty());
    shown.axis.setHidden(true);
    QTest::keyClick(&shown.axis, Qt::Key_Up);
    QCOMPARE(shown.chosen.size(), std::size_t(8));
  }

  void speech_ofTheAxis_isASliderAtTheTorpedo_amongTheCrossings() {
    ShownAxis shown(m_typesetter);
    QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(&shown.axis);
    QCOMPARE(spoken->role(), QAccessible::Slider);
    QCOMPARE(spoken->text(QAccessible::Value), QString("λ = 0"));
    shown.axis.setTime(1.0 / 3, 1.0 / 3);
    QCOMPARE(spoken->text(QAccessible::Value), QString("λ ≈ 0.333"));
    QCOMPARE(spoken->valueInterface()->currentValue().toDouble(), 1.0 / 3);
    QCOMPARE(spoken->valueInterface()->maximumValue().toDouble(), shown.axis.placed().scale().range.high);
    spoken->valueInterface()->setCurrentValue(0.5);
    QCOMPARE(shown.scrubbed, std::vector<double>{0.5});
    QVERIFY(spoken->text(QAccessible::Description)
                .startsWith("barn 4: λ = −1/4, behind the start; barn 3: λ = 1/2, hit first; "));
    shown.axis.setHidden(true);
    QCOMPARE(spoken->text(QAccessible::Value), QString("λ = ?"));
    QCOMPARE(spoken->text(QAccessible::Description), QString());
    QCOMPARE(spoken->valueInterface()->currentValue().toDouble(), 0.0);
  }

  void speech_ofAChosenCrossing_isInTheNameOfTheFocusedAxis() {
    ShownAxis shown(m_typesetter);
    shown.axis.show();
    QVERIFY(QTest::qWaitForWindowActive(&shown.axis));
    shown.axis.setFocus();
    Crossings crossings = someCrossings();
    crossings.chosen = 3;
    shown.axis.setCrossings(crossings);
    QCOMPARE(shown.axis.accessibleName(), QString("The ray's parameter λ: barn 3: λ = 1/2, hit first"));
    shown.axis.setHidden(true);
    QCOMPARE(shown.axis.accessibleName(), QString("The ray's parameter λ"));
  }

  void hidden_showsNoMark_andTakesNoDrag() {
    ShownAxis shown(m_typesetter);
    Crossings far = someCrossings();
    far.all[3].at->t = 9;
    shown.axis.setCrossings(far);
    shown.axis.setTime(0.5, 0.5);
    shown.axis.setHidden(true);
    QVERIFY(shown.axis.placed().scale().range == AxisRange());
    QVERIFY(!shown.axis.placed().placeOf(3));
    QCOMPARE(shown.axis.placed().handle().x(), shown.axis.placed().scale().xOf(0));
    dragPointer(shown.axis, shown.onLine(0) - QPoint(4, 0), shown.onLine(1));
    QTest::keyClick(&shown.axis, Qt::Key_Right);
    QVERIFY(shown.scrubbed.empty());
  }

  void largerType_makesAHigherAxis() {
    ShownAxis shown(m_typesetter);
    const int usual = shown.axis.sizeHint().height();
    QFont large = shown.axis.font();
    large.setPointSizeF(large.pointSizeF() * 2.5);
    shown.axis.setFont(large);
    QVERIFY(shown.axis.sizeHint().height() > 2 * usual);
  }
};

QTEST_MAIN(FlightAxisTest)
#include "flight_axis_test.moc"
