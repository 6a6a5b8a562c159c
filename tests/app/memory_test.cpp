// Resident memory of the window in long use. A program of its own: what other tests leave would be counted
// too.
#include "app/export/figure_export.h"
#include "app/memory.h"
#include "tests/app/window_fixture.h"

#include <QFile>

#include <unistd.h>

using namespace halfspace;

namespace {

/// Of this process, in MB; 0 where the system does not tell it this way.
double residentMemory() {
  QFile file("/proc/self/statm");
  if (!file.open(QIODevice::ReadOnly))
    return 0;
  return file.readAll().split(' ').value(1).toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

void resizeAndCopy(WindowFixture &fixture, QSize size) {
  fixture.window.resize(size);
  QTest::qWait(300); // the view rests and is drawn smoothly
  fixture.window.findChild<FigureExport *>()->copy();
}

} // namespace

class MemoryTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    returnLargeBuffers();
  }

  void pictures_copiedAtManySizes_leaveNoMemoryBehind() {
    if (residentMemory() == 0)
      QSKIP("The system does not tell the resident memory.");
    constexpr double mostGrowth = 80; // MB; the picture in the clipboard has up to 25
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.window.resize(1400, 900);
    QTest::qWait(500);
    const double before = residentMemory();
    for (int round = 0; round < 10; ++round)
      resizeAndCopy(fixture, {1000 + round % 5 * 170, 700 + round % 3 * 130});
    resizeAndCopy(fixture, {1400, 900});
    const double growth = residentMemory() - before;
    qInfo("grown by %.0f MB", growth);
    QVERIFY2(growth < mostGrowth, qPrintable(QString("grown by %1 MB").arg(growth)));
  }
};

QTEST_MAIN(MemoryTest)
#include "memory_test.moc"
