// Work beside the event loop: what is heard of it, and of what was cancelled.
#include "widgets/latest_job.h"

#include <QtTest>

#include <thread>

using namespace halfspace;

namespace {

constexpr int longest = 10000; // milliseconds

void waitUntil(const std::atomic<bool> &flag) {
  while (!flag)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

} // namespace

class LatestJobTest : public QObject {
  Q_OBJECT

private slots:
  void messages_areHeardInOrderInTheOwnersThread_andTheLastWhenItNoLongerRuns() {
    LatestJob job;
    QStringList heard;
    const auto hear = [&](const QString &what) {
      QCOMPARE(QThread::currentThread(), thread());
      heard << what + (job.isRunning() ? " while it runs" : " after it");
    };
    job.start([&](const std::atomic<bool> &, const LatestJob::Post &post) -> LatestJob::Message {
      post([&] { hear("one"); });
      post([&] { hear("two"); });
      return [&] { hear("last"); };
    });
    QVERIFY(job.isRunning());
    QVERIFY(QTest::qWaitFor([&] { return !job.isRunning(); }, longest));
    QCOMPARE(heard, QStringList({"one while it runs", "two while it runs", "last after it"}));
    QVERIFY(!job.cancel());
  }

  void cancelled_isNotHeardAnyMore_notEvenWhatItHasPosted() {
    LatestJob job;
    std::atomic<bool> hasPosted{false};
    std::atomic<bool> hasEnded{false};
    QStringList heard;
    job.start([&](const std::atomic<bool> &cancelled, const LatestJob::Post &post) -> LatestJob::Message {
      post([&] { heard << "of the first"; });
      hasPosted = true;
      waitUntil(cancelled);
      post([&] { heard << "of the first"; });
      hasEnded = true;
      return [&] { heard << "of the first"; };
    });
    waitUntil(hasPosted);
    job.start([&](const std::atomic<bool> &, const LatestJob::Post &) -> LatestJob::Message {
      waitUntil(hasEnded);
      return [&] { heard << "of the second"; };
    });
    QVERIFY(QTest::qWaitFor([&] { return !job.isRunning(); }, longest));
    QTest::qWait(50);
    QCOMPARE(heard, QStringList("of the second"));
  }

  void itsEnd_waitsForTheWork() {
    std::atomic<bool> hasEnded{false};
    bool wasHeard = false;
    {
      LatestJob job;
      job.start([&](const std::atomic<bool> &cancelled, const LatestJob::Post &) -> LatestJob::Message {
        waitUntil(cancelled);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        hasEnded = true;
        return [&] { wasHeard = true; };
      });
    }
    QVERIFY(hasEnded);
    QCoreApplication::processEvents();
    QVERIFY(!wasHeard);
  }
};

QTEST_GUILESS_MAIN(LatestJobTest)
#include "latest_job_test.moc"
