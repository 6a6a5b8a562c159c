// What the mouse must do for a number to be scrubbed, and what that tells.
#include "widgets/numbers/scrub.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QWidget>
#include <QtTest>

using namespace halfspace;

namespace {

/// A widget whose number is scrubbed, and what it is told.
struct Scrubbed {
  Scrubbed() { widget.show(); }

  void press(QPoint at) {
    scrub.press(QMouseEvent(QEvent::MouseButtonPress, at, at, Qt::LeftButton, {}, {}));
  }
  void move(QPoint to) {
    scrub.move(QMouseEvent(QEvent::MouseMove, to, to, Qt::NoButton, Qt::LeftButton, {}));
  }
  int lastSteps() const { return moved.last().at(0).toInt(); }

  QWidget widget;
  Scrub scrub{widget};
  QSignalSpy started{&scrub, &Scrub::started};
  QSignalSpy moved{&scrub, &Scrub::moved};
  QSignalSpy ended{&scrub, &Scrub::ended};
};

} // namespace

class ScrubTest : public QObject {
  Q_OBJECT

private slots:
  void press_thatTrembles_isAClickAndNoScrub() {
    Scrubbed number;
    number.press({20, 8});
    for (const QPoint at : {QPoint(24, 8), QPoint(16, 8), QPoint(20, 60)})
      number.move(at);
    QVERIFY(number.scrub.isPressed() && !number.scrub.isScrubbing());
    number.scrub.end(true);
    QVERIFY(!number.scrub.isPressed());
    QCOMPARE(number.started.count() + number.moved.count() + number.ended.count(), 0);
  }

  void press_draggedSideways_countsStepsFromWhereItBegan() {
    Scrubbed number;
    number.press({20, 8});
    number.move({44, 90}); // up and down is nothing
    QCOMPARE(number.lastSteps(), 3);
    number.move({20, 8}); // and back
    QCOMPARE(number.lastSteps(), 0);
    number.move({4, 8});
    QCOMPARE(number.lastSteps(), -2);
    QCOMPARE(number.started.count(), 1);
  }

  void scrub_whileItGoesOn_hasTheKeyboard() {
    Scrubbed number;
    number.press({20, 8});
    QVERIFY(!QWidget::keyboardGrabber());
    number.move({40, 8});
    QCOMPARE(QWidget::keyboardGrabber(), &number.widget);
    number.scrub.end(false);
    QVERIFY(!QWidget::keyboardGrabber());
  }

  void end_ofAScrub_tellsOnceWhetherItIsKept_data() {
    QTest::addColumn<bool>("keep");
    QTest::newRow("released") << true;
    QTest::newRow("escaped") << false;
  }

  void end_ofAScrub_tellsOnceWhetherItIsKept() {
    QFETCH(bool, keep);
    Scrubbed number;
    number.press({20, 8});
    number.move({40, 8});
    number.scrub.end(keep);
    number.scrub.end(!keep); // the button is still down, and comes up later
    QCOMPARE(number.ended.count(), 1);
    QCOMPARE(number.ended.first().at(0).toBool(), keep);
  }

  void pointer_afterTheEnd_movesNothing() {
    Scrubbed number;
    number.press({20, 8});
    number.move({40, 8});
    number.scrub.end(false);
    number.moved.clear();
    number.move({80, 8});
    QCOMPARE(number.moved.count(), 0);
    QCOMPARE(number.started.count(), 1);
  }
};

QTEST_MAIN(ScrubTest)
#include "scrub_test.moc"
