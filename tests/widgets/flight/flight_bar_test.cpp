// The controls of a flight: what they ask for, and what they show.
#include "widgets/flight/flight_bar.h"

#include "tests/widgets/flight/some_crossings.h"

#include <QMenu>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest>

using namespace halfspace;
using namespace halfspace::test;

class FlightBarTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void buttons_whenClicked_askAndWaitToBeTold() {
    FlightBar bar(m_typesetter);
    QSignalSpy fired(&bar, &FlightBar::fire);
    QSignalSpy played(&bar, &FlightBar::playToggled);
    QSignalSpy stepped(&bar, &FlightBar::stepped);
    QSignalSpy automatic(&bar, &FlightBar::automaticToggled);
    for (const FlightControl control : {FlightControl::Fire, FlightControl::Play, FlightControl::StepBack,
                                        FlightControl::StepForward, FlightControl::Automatic})
      bar.button(control).click();
    QCOMPARE(fired.size(), 1);
    QCOMPARE(played.at(0).at(0).toBool(), true);
    QCOMPARE(stepped.at(0).at(0).toInt(), -1);
    QCOMPARE(stepped.at(1).at(0).toInt(), 1);
    QCOMPARE(automatic.at(0).at(0).toBool(), true);
    QVERIFY(!bar.button(FlightControl::Automatic).isChecked());
    bar.setState({.t = 0, .isPlaying = true, .isAutomatic = true});
    QVERIFY(bar.button(FlightControl::Automatic).isChecked());
    bar.button(FlightControl::Play).click();
    bar.button(FlightControl::Automatic).click();
    QCOMPARE(played.at(1).at(0).toBool(), false);
    QCOMPARE(automatic.at(1).at(0).toBool(), false);
  }

  void speed_chosenInTheMenu_isAskedFor_andShownOnceTold() {
    FlightBar bar(m_typesetter);
    QSignalSpy changed(&bar, &FlightBar::speedChanged);
    const QToolButton &speed = bar.button(FlightControl::Speed);
    speed.menu()->actions().last()->trigger();
    QCOMPARE(changed.at(0).at(0).toDouble(), 2.0);
    QCOMPARE(speed.text(), QString("1×"));
    bar.setState({.speed = 0.25});
    QCOMPARE(speed.text(), QString("¼×"));
    QVERIFY(speed.menu()->actions().first()->isChecked());
  }

  void seed_isThereWhileItFiresByItself_andIsAskedForOnceTyped() {
    FlightBar bar(m_typesetter);
    bar.show();
    QVERIFY(!bar.seed().isVisible());
    QSignalSpy changed(&bar, &FlightBar::seedChanged);
    bar.setState({.isAutomatic = true, .seed = 12});
    QVERIFY(bar.seed().isVisible());
    QCOMPARE(bar.seed().value(), 12);
    QCOMPARE(changed.size(), 0); // it was told
    bar.seed().selectAll();
    QTest::keyClicks(&bar.seed(), "345");
    QCOMPARE(changed.size(), 0); // not digit by digit
    QTest::keyClick(&bar.seed(), Qt::Key_Return);
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed.at(0).at(0).toInt(), 345);
  }

  void readout_ofARoundedTime_hasNoEquals() {
    FlightBar bar(m_typesetter);
    for (const auto &[t, text] : {std::pair{0.5, "λ = 0.5"},
                                  {1.0 / 3, "λ ≈ 0.333"},
                                  {-0.25, "λ = −0.25"},
                                  {2.0, "λ = 2"},
                                  {12345.678, "λ ≈ 12345.7"}}) {
      bar.setState({.t = t});
      QCOMPARE(bar.readout(), QString(text));
    }
  }

  void hidden_tellsNoTime_andStopsTheControls() {
    FlightBar bar(m_typesetter);
    bar.axis().setCrossings(someCrossings());
    bar.setState({.t = 0.5, .hidden = true});
    QCOMPARE(bar.readout(), QString("λ = ?"));
    QVERIFY(!bar.axis().placed().placeOf(3));
    for (const FlightControl control :
         {FlightControl::Fire, FlightControl::Play, FlightControl::StepBack, FlightControl::StepForward})
      QVERIFY(!bar.button(control).isEnabled());
  }

  void play_withoutMotion_isOffAndSaysWhy() {
    FlightBar bar(m_typesetter);
    bar.setState({.reducedMotion = true});
    QVERIFY(!bar.button(FlightControl::Play).isEnabled());
    QVERIFY(bar.button(FlightControl::Play).toolTip().contains("Motion"));
    QVERIFY(bar.button(FlightControl::StepForward).isEnabled());
  }

  void key_isToldInTheToolTip() {
    FlightBar bar(m_typesetter);
    bar.setKeys(FlightControl::Fire, QKeySequence("T"));
    QCOMPARE(bar.button(FlightControl::Fire).toolTip(), QString("Fire the torpedo (T)"));
    QCOMPARE(bar.button(FlightControl::Fire).accessibleName(), QString("Fire the torpedo"));
  }

  void readout_asTimePasses_movesNothing() {
    FlightBar bar(m_typesetter);
    bar.resize(320, bar.heightForWidth(320));
    const int height = bar.heightForWidth(320);
    for (const double t : {0.0, 0.333, -12.34, 123.456}) {
      bar.setState({.t = t});
      QCOMPARE(bar.heightForWidth(320), height);
    }
  }

  void narrowBar_hasRoomForAll() {
    FlightBar bar(m_typesetter);
    bar.resize(170, bar.heightForWidth(170));
    bar.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bar));
    for (const QToolButton *button : bar.findChildren<QToolButton *>())
      QVERIFY(bar.rect().contains(button->geometry()));
    QVERIFY(bar.rect().contains(bar.axis().geometry()));
  }
};

QTEST_MAIN(FlightBarTest)
#include "flight_bar_test.moc"
