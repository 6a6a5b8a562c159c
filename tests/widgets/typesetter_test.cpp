// The typesetter's queue and cache.
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QtTest>

using namespace halfspace;

namespace {

const LabelStyle style{{0, 0, 0}, {255, 255, 255}, 22};

QStringList numbered(const QString &prefix, int count) {
  QStringList formulas;
  for (int i = 0; i < count; ++i)
    formulas << prefix + QString::number(i);
  return formulas;
}

} // namespace

class TypesetterTest : public QObject {
  Q_OBJECT

private slots:
  void labelIsNullFirstAndThereAfterReady() {
    Typesetter typesetter;
    QSignalSpy ready(&typesetter, &Typesetter::ready);
    QVERIFY(!typesetter.label("x+1", style));
    QVERIFY(ready.wait());
    QVERIFY(typesetter.label("x+1", style));
  }

  void labelIsThePictureThatThePainterMakes() {
    Typesetter typesetter;
    QTRY_VERIFY(typesetter.label("x+1", style));
    const LabelPicture painted = paintLabel(*typesetter.pictureNow("x+1"), style);
    QCOMPARE(typesetter.label("x+1", style)->rgba, painted.rgba);
  }

  void formulaTooLongIsAnErrorAndALabelOfItIsPaintedAllTheSame() {
    Typesetter typesetter;
    const QString tooLong = QStringLiteral("x+").repeated(TypesetWorker::longestLatex);
    QVERIFY(!typesetter.pictureNow(tooLong)->error().isEmpty());
    QTRY_VERIFY(typesetter.label(tooLong, style));
  }

  void askingAgainGivesTheSamePicture() {
    Typesetter typesetter;
    const auto first = typesetter.pictureNow("x+1");
    QCOMPARE(typesetter.known("x+1"), first);
    QCOMPARE(typesetter.pictureNow("x+1"), first);
  }

  void askingNeverWaitsEvenWhileMathJaxLoads() {
    QElapsedTimer clock;
    clock.start();
    Typesetter typesetter;
    for (const QString &latex : numbered("\\frac{1}{2} + ", 30))
      QVERIFY(!typesetter.label(latex, style));
    QVERIFY2(clock.elapsed() < 60, qPrintable(QString::number(clock.elapsed())));
  }

  void picturesThatComeTogetherAreToldOnce() {
    Typesetter typesetter;
    (void)typesetter.pictureNow("x");
    QCoreApplication::processEvents(); // its `ready`
    QSignalSpy ready(&typesetter, &Typesetter::ready);
    Typesetter::Request request(typesetter);
    request.setWanted(numbered("x_", 20));
    QTest::qSleep(1000); // this thread is busy while all are made
    QTRY_VERIFY(request.isComplete());
    QCOMPARE(ready.count(), 1);
  }

  void formulaThatNobodyWantsAnyMoreIsNotMade() {
    Typesetter typesetter;
    Typesetter::Request request(typesetter);
    request.setWanted(numbered("\\sqrt{y} + ", 300));
    request.setWanted({"z"});
    QCOMPARE(typesetter.queueLength(), 1);
    QTRY_VERIFY(request.isComplete());
    QTest::qWait(50);
    QVERIFY(!typesetter.known("\\sqrt{y} + 299"));
    QCOMPARE(typesetter.queueLength(), 0);
  }

  void formulaThatAnotherStillWantsIsMade() {
    Typesetter typesetter;
    Typesetter::Request kept(typesetter);
    kept.setWanted({"a"});
    {
      Typesetter::Request dropped(typesetter);
      dropped.setWanted({"a", "b"});
    }
    QCOMPARE(typesetter.queueLength(), 1);
    QTRY_VERIFY(kept.isComplete());
  }

  void labelsWaitingAreBoundedAndTheLatestAreMade() {
    Typesetter typesetter;
    for (const QString &latex : numbered("n_", 500))
      (void)typesetter.label(latex, style);
    QCOMPARE(typesetter.queueLength(), Typesetter::mostLabelsWaiting);
    QTRY_VERIFY(typesetter.label("n_499", style));
  }

  void cacheForgetsWhatWasNotUsedForLong() {
    Typesetter typesetter(nullptr, 20);
    (void)typesetter.pictureNow("first");
    for (const QString &latex : numbered("x+", 10))
      (void)typesetter.pictureNow(latex);
    QVERIFY(!typesetter.known("first"));
    QVERIFY(typesetter.known("x+9"));
  }

  void wantedPicturesSurviveAFullCache() {
    Typesetter typesetter(nullptr, 20);
    Typesetter::Request request(typesetter);
    request.setWanted({"first"});
    (void)typesetter.pictureNow("first");
    for (const QString &latex : numbered("x+", 10))
      (void)typesetter.pictureNow(latex);
    QVERIFY(request.isComplete());
    QVERIFY(typesetter.known("first"));
  }

  void endingWithAFullQueueIsQuick() {
    QElapsedTimer clock;
    {
      Typesetter typesetter;
      (void)typesetter.pictureNow("x");
      for (const QString &latex : numbered("\\sqrt{\\frac{1}{x}} + ", 60))
        (void)typesetter.label(latex, style);
      clock.start();
    }
    QVERIFY2(clock.elapsed() < 300, qPrintable(QString::number(clock.elapsed())));
  }

  void longFormula() {
    Typesetter typesetter;
    (void)typesetter.pictureNow("x");
    int i = 0;
    QBENCHMARK {
      (void)typesetter.pictureNow(
          QStringLiteral("t = \\frac{(\\mark{P0}{P_0}-\\mark{Q}{Q})\\cdot\\mark{n}{\\vec n}}"
                         "{\\mark{r}{\\vec r}\\cdot\\mark{n}{\\vec n}} = %1")
              .arg(++i));
    }
  }
};

QTEST_MAIN(TypesetterTest)
#include "typesetter_test.moc"
