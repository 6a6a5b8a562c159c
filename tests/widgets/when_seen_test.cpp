// What is made for a widget at once, and what waits until it is seen.
#include "widgets/when_seen.h"

#include <QVBoxLayout>
#include <QWidget>
#include <QtTest>

using namespace halfspace;

namespace {

/// A widget in a window, both to be shown.
struct Fixture {
  QWidget window;
  QWidget *widget = new QWidget;
  int made = 0;
  WhenSeen whenSeen{*widget, [this] { ++made; }};

  Fixture() { (new QVBoxLayout(&window))->addWidget(widget); }
};

} // namespace

class WhenSeenTest : public QObject {
  Q_OBJECT

private slots:
  void widgetThatIsStillToBeShown_isMadeAtOnce_andNotAgainWhenItIs() {
    Fixture fixture;
    QVERIFY(fixture.whenSeen.renew());
    QCOMPARE(fixture.made, 1);
    fixture.window.show();
    QCOMPARE(fixture.made, 1);
    QVERIFY(fixture.whenSeen.renew());
    QCOMPARE(fixture.made, 2);
  }

  void widgetWithNothingNew_isNotMadeWhenItComesIntoSight() {
    Fixture fixture;
    fixture.window.show();
    fixture.widget->hide();
    fixture.widget->show();
    QCOMPARE(fixture.made, 0);
  }

  void hiddenWidget_isMadeOnceItIsSeen_howeverOftenItIsRenewed() {
    Fixture fixture;
    fixture.window.show();
    fixture.widget->hide();
    QVERIFY(!fixture.whenSeen.renew());
    QVERIFY(!fixture.whenSeen.renew());
    QCOMPARE(fixture.made, 0);
    fixture.widget->show();
    QCOMPARE(fixture.made, 1);
    fixture.widget->hide();
    fixture.widget->show();
    QCOMPARE(fixture.made, 1);
  }

  void widgetInWhatIsHidden_isMadeOnceThatIsSeen() {
    QWidget outer;
    Fixture fixture;
    (new QVBoxLayout(&outer))->addWidget(&fixture.window);
    outer.show();
    fixture.window.hide();
    QVERIFY(!fixture.whenSeen.renew());
    fixture.window.show();
    QCOMPARE(fixture.made, 1);
    fixture.window.setParent(nullptr);
  }

  void widgetInAWindowThatWasClosed_isMadeOnceThatIsOpenedAgain() {
    Fixture fixture;
    fixture.window.show();
    fixture.window.hide();
    QVERIFY(!fixture.whenSeen.renew());
    fixture.window.show();
    QCOMPARE(fixture.made, 1);
  }
};

QTEST_MAIN(WhenSeenTest)
#include "when_seen_test.moc"
