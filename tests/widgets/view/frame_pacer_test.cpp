// When a frame is due: once for all that was asked for, and before a window shows something older.
#include "widgets/view/frame_pacer.h"

#include <QtTest>

using namespace halfspace;

class FramePacerTest : public QObject {
  Q_OBJECT

private slots:
  void manyRequests_areOneFrame() {
    QWidget view;
    FramePacer frames(view);
    QSignalSpy due(&frames, &FramePacer::due);
    for (int i = 0; i < 5; ++i)
      frames.request();
    QTRY_COMPARE(due.count(), 1);
    QTest::qWait(20);
    QCOMPARE(due.count(), 1);
  }

  void request_beforeTheLastFrameIsSeen_waitsForThat() {
    QWidget view;
    FramePacer frames(view);
    QSignalSpy due(&frames, &FramePacer::due);
    frames.begin();
    frames.awaitPaint();
    frames.request();
    QTest::qWait(20);
    QCOMPARE(due.count(), 0);
    frames.painted();
    QTRY_COMPARE(due.count(), 1);
  }

  void whatIsNew_isTakenOnce() {
    QWidget view;
    FramePacer frames(view);
    QVERIFY2(frames.takeNew(), "nothing has been drawn yet");
    QVERIFY(!frames.takeNew());
    frames.requestNew();
    QVERIFY(frames.takeNew());
  }

  void whatMoves_restsLater_andIsDrawnOnceMore() {
    QWidget view;
    FramePacer frames(view);
    QSignalSpy due(&frames, &FramePacer::due);
    frames.requestMoving();
    QVERIFY(frames.isMoving());
    QTRY_COMPARE(due.count(), 1);
    QVERIFY(frames.isMoving());
    QTRY_COMPARE(due.count(), 2);
    QVERIFY(!frames.isMoving());
  }

  void window_isPutTogether_afterWhatIsNewWasDrawn() {
    QWidget window;
    QWidget view(&window);
    FramePacer frames(view);
    QSignalSpy due(&frames, &FramePacer::due);
    const auto putTogether = [&] {
      due.clear();
      QEvent request(QEvent::UpdateRequest);
      QCoreApplication::sendEvent(&window, &request);
      return due.count();
    };
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(putTogether() > 0);
    (void)frames.takeNew();
    QCOMPARE(putTogether(), 0);
  }
};

QTEST_MAIN(FramePacerTest)
#include "frame_pacer_test.moc"
