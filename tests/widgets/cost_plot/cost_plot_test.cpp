// The plot of what a search costs: measured when it is asked for, and stopped.
#include "widgets/cost_plot/cost_plot.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include <future>

using namespace halfspace;

namespace {

constexpr int longest = 30000;

const Ray<Rational> shot{{6, 7, 14}, {2, 1, -2}};

Aim aim() {
  const std::vector<Vec3<double>> corners{{0, 0, 0}, {99, 0, 0}, {0, 99, 0}};
  return {shot,
          {{{}, {1, 0, 0}, 1, std::make_shared<const MeshShape>(corners, std::vector<MeshFace>{{0, 1, 2}})}}};
}

/// A measuring that takes until it is let go on, whether cancelled or not.
class HeldMeasuring {
public:
  [[nodiscard]] CostPlot::Measure measure() {
    return [this](const Aim &, const std::atomic<bool> &, const TellCost &tell, std::size_t) {
      hasBegun = true;
      (void)m_opened.wait_for(std::chrono::milliseconds(longest)); // not for ever where the test fails
      CostPoint point;
      point.triangles = fewestMeasured;
      tell(point);
      hasEnded = true;
    };
  }
  void goOn() { m_gate.set_value(); }

  std::atomic<bool> hasBegun{false};
  std::atomic<bool> hasEnded{false};

private:
  std::promise<void> m_gate;
  std::future<void> m_opened = m_gate.get_future();
};

/// Curves of a scene alone.
QImage picture(CostQuantity quantity, const std::optional<CostPoint> &inScene) {
  CostCurves curves;
  curves.resize(400, 300);
  curves.setQuantity(quantity);
  curves.setPoints({}, inScene);
  return curves.grab().toImage();
}

struct ShownPlot {
  explicit ShownPlot(const CostPlot::Measure &measure = measureCost)
      : plot(std::make_unique<CostPlot>(job, measure)) {
    plot->setMost(1000);
    plot->setAim(aim());
    plot->resize(400, 400);
    plot->show();
  }
  [[nodiscard]] QPushButton *button() const { return plot->findChild<QPushButton *>("measure"); }
  void click() const { QTest::mouseClick(button(), Qt::LeftButton); }

  LatestJob job;
  std::unique_ptr<CostPlot> plot;
  QSignalSpy measured{plot.get(), &CostPlot::measured};
  QSignalSpy ended{plot.get(), &CostPlot::ended};
};

} // namespace

class CostPlotTest : public QObject {
  Q_OBJECT

private slots:
  void click_onMeasure_showsEachPointAsItIsMeasured() {
    const ShownPlot shown;
    QCOMPARE(
        shown.plot->sentence(),
        QString(
            "Press Measure: the shot is fired at the scene, and at bumpy fields of 100 to 1,000 triangles."));
    const QImage before = shown.plot->grab().toImage();
    shown.click();
    QCOMPARE(shown.button()->text(), QString("Stop"));
    QVERIFY(QTest::qWaitFor([&] { return shown.ended.count() > 0; }, longest));
    QCOMPARE(shown.measured.count(), 3);
    QCOMPARE(shown.plot->points().back().triangles, std::size_t(1000));
    QCOMPARE(shown.button()->text(), QString("Measure"));
    QVERIFY(shown.plot->sentence().startsWith("The scene, 1 triangle: the loop asked all 1 in "));
    QVERIFY(shown.plot->sentence().contains("\nA field, 1,000 triangles: the loop asked all 1,000 in "));
    QVERIFY(shown.plot->grab().toImage() != before);
  }

  void aim_turnedAfterItWasMeasured_isTold_untilItIsMeasuredAgain() {
    const ShownPlot shown;
    shown.plot->setMost(100);
    shown.click();
    QVERIFY(QTest::qWaitFor([&] { return shown.ended.count() > 0; }, longest));
    QVERIFY(!shown.plot->sentence().contains("has moved"));
    Aim turned = aim();
    turned.ray.direction.x = 3;
    shown.plot->setAim(turned);
    QVERIFY(shown.plot->sentence().endsWith("\nSomething has moved since this was measured."));
    shown.plot->setAim(aim()); // whose mesh is another one
    QVERIFY(shown.plot->sentence().endsWith("\nSomething has moved since this was measured."));
    shown.click();
    QVERIFY(!shown.plot->sentence().contains("has moved"));
    QVERIFY(QTest::qWaitFor([&] { return shown.ended.count() > 1; }, longest));
    QVERIFY(!shown.plot->sentence().contains("has moved"));
  }

  void click_onStop_endsIt_andTheNextMeasuringBeginsAnew() {
    const ShownPlot shown;
    shown.plot->setMost(mostMeasured);
    shown.click();
    QVERIFY(QTest::qWaitFor([&] { return shown.measured.count() > 0; }, longest));
    shown.click();
    QVERIFY(!shown.plot->isMeasuring());
    QCOMPARE(shown.ended.count(), 1);
    const std::size_t there = shown.plot->points().size();
    QTest::qWait(100);
    QCOMPARE(shown.plot->points().size(), there);
    shown.plot->setMost(100);
    shown.click();
    QVERIFY(QTest::qWaitFor([&] { return shown.ended.count() > 1; }, longest));
    QCOMPARE(shown.plot->points().size(), std::size_t(1));
    QVERIFY(shown.plot->inScene().has_value());
  }

  void plot_destroyedWhileItMeasures_doesNotWait_andLeavesTheJobToTheNext() {
    HeldMeasuring held;
    ShownPlot shown(held.measure());
    shown.click();
    QVERIFY(QTest::qWaitFor([&] { return held.hasBegun.load(); }, longest));
    shown.plot.reset();
    QVERIFY(!held.hasEnded);
    QVERIFY(!shown.job.isRunning());
    CostPlot next(shown.job);
    next.setMost(fewestMeasured);
    next.setAim(aim());
    QSignalSpy ended(&next, &CostPlot::ended);
    next.findChild<QPushButton *>("measure")->click();
    held.goOn();
    QVERIFY(QTest::qWaitFor([&] { return held.hasEnded && ended.count() > 0; }, longest));
    QCOMPARE(next.points().size(), std::size_t(1));
    QCOMPARE(shown.measured.count(), 0);
  }

  void plot_destroyedWhileItDoesNotMeasure_leavesTheJobOfAnother() {
    HeldMeasuring held;
    ShownPlot shown(held.measure());
    shown.click();
    { const CostPlot other(shown.job); }
    QVERIFY(shown.job.isRunning());
    held.goOn();
    QVERIFY(QTest::qWaitFor([&] { return shown.ended.count() > 0; }, longest));
    QCOMPARE(shown.measured.count(), 1);
  }

  void withoutARay_thereIsNothingToMeasure_butMeasuringGoesOn() {
    const ShownPlot shown;
    shown.plot->setAim({});
    QVERIFY(!shown.button()->isEnabled());
    shown.plot->setAim(aim());
    shown.click();
    shown.plot->setAim({});
    QVERIFY(shown.button()->isEnabled());
    QVERIFY(QTest::qWaitFor([&] { return shown.ended.count() > 0; }, longest));
    QVERIFY(!shown.button()->isEnabled());
  }

  void curves_whereNothingIsLookedAt_areDrawnAsWhereOneThingIs() {
    CostPoint nothing;
    nothing.triangles = 1; // without an area
    CostPoint one = nothing;
    one.plain = one.tree = {0, 1};
    QCOMPARE(picture(CostQuantity::LookedAt, nothing), picture(CostQuantity::LookedAt, one));
  }

  void curves_ofNoTimeAtAll_areDrawnAsThoseOfANanosecond() {
    CostPoint none;
    none.triangles = 1;
    CostPoint nanosecond = none;
    nanosecond.plainMicroseconds = nanosecond.treeMicroseconds = 0.001;
    QCOMPARE(picture(CostQuantity::Time, none), picture(CostQuantity::Time, nanosecond));
  }

  void curves_ofASceneOfOneTriangle_markItWithinThePlot() {
    CostPoint one;
    one.triangles = 1;
    one.plain = one.tree = {0, 1};
    const QImage empty = picture(CostQuantity::LookedAt, {});
    const QImage marked = picture(CostQuantity::LookedAt, one);
    int leftmost = marked.width();
    for (int y = 0; y < marked.height(); ++y)
      for (int x = 0; x < marked.width(); ++x)
        if (marked.pixel(x, y) != empty.pixel(x, y))
          leftmost = std::min(leftmost, x);
    const int numbers = QFontMetrics(QApplication::font()).horizontalAdvance("10"); // beside the plot
    QVERIFY2(leftmost > numbers, qPrintable(QString::number(leftmost)));
    QVERIFY(leftmost < marked.width() / 2);
  }

  void click_onTime_showsTheTimes() {
    const ShownPlot shown;
    shown.click();
    QVERIFY(QTest::qWaitFor([&] { return shown.ended.count() > 0; }, longest));
    const auto curves = shown.plot->findChild<CostCurves *>();
    const QImage before = curves->grab().toImage();
    QTest::mouseClick(shown.plot->findChild<QToolButton *>("time"), Qt::LeftButton);
    QVERIFY(curves->grab().toImage() != before);
  }
};

QTEST_MAIN(CostPlotTest)
#include "cost_plot_test.moc"
