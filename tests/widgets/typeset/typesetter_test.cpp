// Formulas are there when they are asked for.
#include "widgets/typeset/typesetter.h"

#include <QtTest>

using namespace halfspace;

class TypesetterTest : public QObject {
  Q_OBJECT

private slots:
  void pictureIsTheSameWhenAskedAgain() {
    const Typesetter typesetter;
    const auto first = typesetter.picture("x+1");
    QVERIFY(first->error().isEmpty());
    QCOMPARE(typesetter.picture("x+1")->box(), first->box());
  }

  void formulaTooLongIsAnErrorWithAPicture() {
    const Typesetter typesetter;
    const auto picture = typesetter.picture(QStringLiteral("x+").repeated(100'000));
    QVERIFY(!picture->error().isEmpty());
    QVERIFY(picture->width() > 0);
  }

  void longFormula() {
    const Typesetter typesetter;
    int i = 0;
    QBENCHMARK {
      (void)typesetter.picture(
          QStringLiteral("t = \\frac{(\\mark{P0}{P_0}-\\mark{Q}{Q})\\cdot\\mark{n}{\\vec n}}"
                         "{\\mark{r}{\\vec r}\\cdot\\mark{n}{\\vec n}} = %1")
              .arg(++i));
    }
  }
};

QTEST_MAIN(TypesetterTest)
#include "typesetter_test.moc"
