// One dot for each step: where it is painted, clicked and told.
#include "widgets/lesson/step_dots.h"

#include "widgets/colors.h"

#include <QHelpEvent>
#include <QPixmap>
#include <QSignalSpy>
#include <QToolTip>
#include <QtTest>

#include <set>

using namespace halfspace;

namespace {

Theme themeOfSize(double textScale) {
  Theme theme = themes().front();
  theme.textScale = textScale;
  return theme;
}

/// Dots of four steps, the third of them shown.
struct ShownDots {
  explicit ShownDots(double textScale = 1) {
    dots.setSteps({"Two sides", "The sign", "The distance", "The end"});
    dots.setTheme(themeOfSize(textScale));
    dots.setCurrent(2);
    dots.resize(dots.sizeHint());
  }
  [[nodiscard]] QPoint middleOf(int step) const {
    const double width = dots.width() / 4.0;
    return {static_cast<int>(width * (step + 0.5)), dots.height() / 2};
  }
  QColor inkOf(int step) { return dots.grab().toImage().pixelColor(middleOf(step)); }

  StepDots dots;
  QSignalSpy clicked{&dots, &StepDots::clicked};
};

} // namespace

class StepDotsTest : public QObject {
  Q_OBJECT

private slots:
  void click_onADot_asksForItsStep_data() {
    QTest::addColumn<double>("textScale");
    QTest::newRow("usual") << 1.0;
    QTest::newRow("projector") << 1.75;
  }

  void click_onADot_asksForItsStep() {
    QFETCH(double, textScale);
    ShownDots shown(textScale);
    for (int step = 0; step < 4; ++step) {
      QTest::mouseClick(&shown.dots, Qt::LeftButton, {}, shown.middleOf(step));
      QCOMPARE(shown.clicked.takeLast().at(0).toInt(), step);
    }
  }

  void click_besideTheDots_asksForTheNearest() {
    ShownDots shown;
    shown.dots.resize(shown.dots.width() + 200, shown.dots.height());
    QTest::mouseClick(&shown.dots, Qt::LeftButton, {}, {shown.dots.width() - 1, 3});
    QCOMPARE(shown.clicked.takeLast().at(0).toInt(), 3);
  }

  void click_withoutSteps_asksForNothing() {
    ShownDots shown;
    shown.dots.setSteps({});
    QTest::mouseClick(&shown.dots, Qt::LeftButton, {}, {3, 3});
    QVERIFY(shown.clicked.isEmpty());
  }

  void dots_ofAllSteps_areToldApart() {
    ShownDots shown;
    QCOMPARE(shown.inkOf(2), toQColor(themes().front().accent));
    QCOMPARE(shown.inkOf(0), shown.inkOf(1)); // both are passed
    const std::set<QRgb> inks{shown.inkOf(0).rgb(), shown.inkOf(2).rgb(), shown.inkOf(3).rgb()};
    QCOMPARE(inks.size(), std::size_t(3));
  }

  void speech_tellsWhichStepOfHowManyIsShown() {
    ShownDots shown;
    QCOMPARE(shown.dots.accessibleName(), QString("Step 3 of 4"));
    shown.dots.setCurrent(0);
    QCOMPARE(shown.dots.accessibleName(), QString("Step 1 of 4"));
    shown.dots.setSteps({"Only one"});
    QCOMPARE(shown.dots.accessibleName(), QString("Step 1 of 1"));
  }

  void toolTip_onADot_isTheTitleOfItsStep() {
    ShownDots shown;
    shown.dots.show();
    QVERIFY(QTest::qWaitForWindowExposed(&shown.dots));
    for (const auto &[step, title] : {std::pair{1, "The sign"}, {3, "The end"}}) {
      QHelpEvent help(QEvent::ToolTip, shown.middleOf(step), shown.dots.mapToGlobal(shown.middleOf(step)));
      QCoreApplication::sendEvent(&shown.dots, &help);
      QCOMPARE(QToolTip::text(), QString(title));
    }
  }

  void largerType_makesLargerDots() {
    QCOMPARE(ShownDots(2).dots.sizeHint(), 2 * ShownDots(1).dots.sizeHint());
  }
};

QTEST_MAIN(StepDotsTest)
#include "step_dots_test.moc"
