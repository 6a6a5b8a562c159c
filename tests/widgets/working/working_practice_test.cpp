// Worked lines that the learner fills in, with real keys and clicks.
#include "tests/lessons/called_line.h"
#include "widgets/working/working_practice.h"

#include "lessons/object/object.h"
#include "lessons/term/rewrite.h"

#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include <algorithm>

using namespace halfspace;
using test::called;

namespace {

/// f(Q) = 2·15 = 30, h = f(Q)/3 = 10, F = (1, 2, 3)
Working someWorking(int value = 30) {
  const Term f = applied(letter("f"), name(letter("Q"), ExactVec3(1, 0, 0)), Rational(value));
  const Term h = name(letter("h"), Rational(value, 3));
  const Term F = name(letter("F"), ExactVec3(1, 2, 3));
  return {{called("f", asked(Chain(f).then(2 * Term(Rational(value, 2))).then(calculated(f)))),
           called("distance",
                  asked(withNumbers(h == f / 3), "Divided by the length.", {{f, "{answer} is f(Q)."}})),
           called("foot", line(withResult(F)))}};
}

QToolButton *button(const QWidget &widget, const QString &text, int which = 0) {
  for (QToolButton *found : widget.findChildren<QToolButton *>())
    if (found->text() == text && found->isVisibleTo(&widget) && which-- == 0)
      return found;
  return nullptr;
}

QList<QLineEdit *> fields(const QWidget &widget) {
  QList<QLineEdit *> shown;
  for (QLineEdit *field : widget.findChildren<QLineEdit *>())
    if (field->isVisibleTo(&widget) && field->isEnabled())
      shown << field;
  std::sort(shown.begin(), shown.end(), [](const QLineEdit *a, const QLineEdit *b) {
    return a->parentWidget()->y() < b->parentWidget()->y();
  });
  return shown;
}

QString score(const QWidget &practice) {
  const auto *label = practice.findChild<QLabel *>("score");
  return label->isVisibleTo(&practice) ? label->text() : QString();
}

QString text(const std::vector<PlacedText> &pieces) {
  QString all;
  for (const PlacedText &piece : pieces)
    all += piece.text;
  return all;
}

void answer(QLineEdit *field, const QString &text) {
  QTest::mouseClick(field, Qt::LeftButton);
  field->selectAll();
  QTest::keyClicks(field, text);
  QTest::keyClick(field, Qt::Key_Return);
}

} // namespace

class WorkingPracticeTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

  void show(WorkingPractice &practice) {
    practice.resize(500, 500);
    practice.show();
    practice.setStep("lesson", 0, {});
    practice.setWorking(someWorking(), false);
  }

  static PlacedLine line(WorkingPractice &practice, std::size_t index) {
    return practice.panel().placed().lines.at(index);
  }

private slots:
  void allLinesAreShownUntilTheLearnerChooses() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QVERIFY(!practice.hasBlanks());
    QVERIFY(fields(practice).isEmpty());
    QVERIFY(button(practice, "All lines")->isChecked());
    QSignalSpy changed(&practice, &WorkingPractice::blanksChanged);
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    QCOMPARE(changed.count(), 1);
    QVERIFY(practice.hasBlanks());
    QCOMPARE(fields(practice).size(), 1);
    QVERIFY(line(practice, 0).blank.isNull());
    QVERIFY(!line(practice, 1).blank.isNull());
    QVERIFY(line(practice, 2).blank.isNull());                   // it asks for nothing …
    QCOMPARE(line(practice, 2).formulas.size(), std::size_t(1)); // … but waits with its numbers
    QVERIFY(!practice.panel().latexOfAll().contains("10"));
    QVERIFY(text(line(practice, 1).sentence).isEmpty());
  }

  void wrongAnswerIsToldByItsMistakeAndTheRightOneOpensTheLine() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    answer(fields(practice).first(), "30");
    QCOMPARE(text(line(practice, 1).remark), QString("30 is f(Q)."));
    QVERIFY(practice.hasBlanks());
    answer(fields(practice).first(), "10");
    QVERIFY(!practice.hasBlanks());
    QVERIFY(fields(practice).isEmpty());
    QCOMPARE(text(line(practice, 1).remark), QString("Right."));
    QCOMPARE(text(line(practice, 1).sentence), QString("Divided by the length."));
    QVERIFY(practice.panel().latexOfAll().contains("= 10"));
  }

  void answerIsReadAndToldInTheLanguageOfTheLearner() {
    WorkingPractice practice(m_typesetter);
    practice.setLocale(QLocale(QLocale::German));
    Working working = someWorking();
    working.lines.push_back(
        called("G", asked(withResult(name(letter("G"), ExactVec3(Rational(3, 2), 2, 3))))));
    show(practice);
    practice.setWorking(working, false);
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    answer(fields(practice).first(), "1,25");
    QVERIFY(text(line(practice, 3).remark).contains("(1, 2, 3)")); // so many are asked for …
    answer(fields(practice).first(), "(1, 2, 3)");
    QVERIFY(text(line(practice, 3).remark).contains("(1, 2, 3) is not right")); // … and these can be typed
    answer(fields(practice).first(), "(1,5; 2; 3)");
    QCOMPARE(text(line(practice, 3).remark), QString("Right."));
  }

  void rightAnswerHandsTheKeysToTheNextField() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    practice.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&practice));
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    QCOMPARE(fields(practice).size(), 2);
    QTRY_VERIFY(fields(practice).first()->hasFocus());
    answer(fields(practice).first(), "30");
    QCOMPARE(fields(practice).size(), 1);
    QTRY_VERIFY(fields(practice).first()->hasFocus());
  }

  void showButtonRevealsALineWithoutAnAnswer() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    QCOMPARE(line(practice, 2).formulas.size(), std::size_t(1));
    QTest::mouseClick(button(practice, "Show", 0), Qt::LeftButton);
    QTest::mouseClick(button(practice, "Show", 0), Qt::LeftButton);
    QVERIFY(!practice.hasBlanks());
    QCOMPARE(line(practice, 2).formulas.size(), std::size_t(2)); // it has waited
  }

  void gapStandsInTheFormulaAndAsksForThatNumber() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "Gaps"), Qt::LeftButton);
    QVERIFY(practice.hasBlanks());
    const PlacedLine distance = line(practice, 1); // h = f(Q)/3 = 30/3 = 10, without one of its numbers
    QVERIFY(!distance.blank.isNull());
    QCOMPARE(distance.formulas.size(), std::size_t(3));
    const auto holder = std::find_if(distance.formulas.begin(), distance.formulas.end(),
                                     [](const PlacedFormula &formula) { return formula.picture->leftOut(); });
    QVERIFY(holder != distance.formulas.end());
    QVERIFY(holder->box().adjusted(-1, -1, 1, 1).contains(distance.blank));
    QLineEdit *field = fields(practice).front();
    QVERIFY(distance.blank.toAlignedRect()
                .adjusted(-1, -1, 1, 1)
                .contains(QRect(field->mapTo(practice.panel().viewport(), QPoint()), field->size())));
    QVERIFY(text(distance.sentence).isEmpty());
    const QString question = field->accessibleName();
    QVERIFY2(question.contains('?'), qPrintable(question));
    answer(field, "10"); // 30 is what the line above comes to
    QVERIFY(line(practice, 1).blank.isNull());
    QCOMPARE(text(line(practice, 1).remark), QString("Right."));
  }

  void whatNoLineSaysIsToldWhereItIsNeeded() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    const Working all = someWorking();
    practice.setWorking({{all.lines[1]}}, false);
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    QCOMPARE(line(practice, 0).formulas.size(), std::size_t(3)); // h = f(Q)/3, = and the field, f(Q) = 30
    QVERIFY(line(practice, 0).formulas.back().box().top() > line(practice, 0).blank.top());
    practice.setWorking({{all.lines[0], all.lines[1]}}, false);
    QCOMPARE(line(practice, 1).formulas.size(), std::size_t(2));
  }

  void changedSceneKeepsTheBlankAndAsksForTheNewNumber() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    answer(fields(practice).first(), "30");
    practice.setWorking(someWorking(60), false);
    QVERIFY(text(line(practice, 1).remark).isEmpty()); // it was about another number
    QVERIFY(practice.hasBlanks());
    answer(fields(practice).first(), "10");
    QVERIFY(practice.hasBlanks());
    answer(fields(practice).first(), "20");
    QVERIFY(!practice.hasBlanks());
    practice.setWorking(someWorking(60), false);
    QVERIFY(!practice.hasBlanks()); // the same numbers are not asked twice
    practice.setWorking(someWorking(90), false);
    QVERIFY(practice.hasBlanks()); // new numbers are
    answer(fields(practice).first(), "30");
    QVERIFY(!practice.hasBlanks());
  }

  void newNumbersBlankAllLinesAgainAndGiveTheFocusToTheFirst() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    practice.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&practice));
    int asked = 0;
    connect(&practice, &WorkingPractice::newNumbersRequested, this, [&] {
      ++asked;
      practice.setWorking(someWorking(60), false);
    });
    QTest::mouseClick(button(practice, "New numbers"), Qt::LeftButton);
    QCOMPARE(asked, 1);
    QVERIFY(fields(practice).isEmpty());
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    answer(fields(practice).first(), "60");
    answer(fields(practice).first(), "7"); // wrong
    QCOMPARE(fields(practice).size(), 1);
    QTest::mouseClick(button(practice, "New numbers"), Qt::LeftButton);
    QCOMPARE(asked, 2);
    QCOMPARE(fields(practice).size(), 2);
    for (const QLineEdit *field : fields(practice))
      QVERIFY(field->text().isEmpty());
    QVERIFY(text(line(practice, 1).remark).isEmpty());
    QTRY_VERIFY(fields(practice).first()->hasFocus());
  }

  void scoreCountsWhatIsRightAtTheFirstTry() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QCOMPARE(score(practice), QString());
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    QCOMPARE(score(practice), QString("0 of 2 right")); // the vector asks for nothing
    answer(fields(practice).first(), "abc");            // no answer
    answer(fields(practice).first(), "30");
    QCOMPARE(score(practice), QString("1 of 2 right"));
    answer(fields(practice).first(), "30"); // wrong
    answer(fields(practice).first(), "10");
    QCOMPARE(score(practice), QString("1 of 2 right"));
    QCOMPARE(practice.findChild<QLabel *>("score")->accessibleName(),
             QString("1 of 2 right at the first try"));
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    QCOMPARE(score(practice), QString("0 of 1 right"));
    QTest::mouseClick(button(practice, "All lines"), Qt::LeftButton);
    QCOMPARE(score(practice), QString());
  }

  void scoreLeavesOutWhatWasShown_andBeginsAnewWithNewNumbers() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    answer(fields(practice).first(), "30");
    QTest::mouseClick(button(practice, "Show", 0), Qt::LeftButton);
    QCOMPARE(score(practice), QString("1 of 2 right"));
    practice.setStep("lesson", 1, Fading::All);
    practice.setWorking(someWorking(), false);
    QCOMPARE(score(practice), QString("0 of 2 right"));
    practice.setStep("lesson", 0, {});
    practice.setWorking(someWorking(), false);
    QCOMPARE(score(practice), QString("1 of 2 right"));
    practice.setWorking(someWorking(), true);
    QCOMPARE(score(practice), QString()); // a question goes before
    practice.setWorking(someWorking(60), false);
    QCOMPARE(score(practice), QString("0 of 2 right"));
    answer(fields(practice).first(), "60");
    QCOMPARE(score(practice), QString("1 of 2 right"));
    QTest::mouseClick(button(practice, "New numbers"), Qt::LeftButton);
    QCOMPARE(score(practice), QString("0 of 2 right")); // even where they are the same
  }

  void choiceOfAnEarlierStartHoldsWhereTheStepAsksForNothingElse() {
    WorkingPractice practice(m_typesetter);
    practice.setUsual(Fading::Last);
    show(practice);
    QVERIFY(button(practice, "Last blank")->isChecked());
    QCOMPARE(fields(practice).size(), 1);
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    QVERIFY(practice.usual() == Fading::All);
  }

  void barIsNeverCutOff() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    for (const int width : {700, 400, 300, 200}) {
      practice.resize(width, 500);
      QCOMPARE(practice.width(), width);
      QRect last;
      for (const char *name : {"All lines", "Gaps", "Last blank", "All blank", "New numbers"}) {
        const QToolButton *shown = button(practice, name);
        QVERIFY(practice.rect().contains(shown->geometry()));
        QVERIFY(shown->width() >= shown->sizeHint().width());
        QVERIFY(!shown->geometry().intersects(practice.panel().geometry()));
        QVERIFY(!shown->geometry().intersects(last));
        last = shown->geometry();
      }
      const auto *score = practice.findChild<QLabel *>("score");
      QVERIFY(practice.rect().contains(score->geometry()));
      QVERIFY(score->width() >= score->sizeHint().width());
      QVERIFY(!score->geometry().intersects(practice.panel().geometry()));
    }
  }

  void stepMayAskForBlanksAndTheLearnersChoiceGoesBefore() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    practice.setStep("lesson", 1, Fading::All);
    practice.setWorking(someWorking(), false);
    QVERIFY(button(practice, "All blank")->isChecked());
    QVERIFY(practice.hasBlanks());
    QTest::mouseClick(button(practice, "All lines"), Qt::LeftButton);
    QVERIFY(!practice.hasBlanks());
    practice.setStep("lesson", 2, {});
    practice.setWorking(someWorking(), false);
    QVERIFY(!practice.hasBlanks());
  }

  void whatWasTypedInOneStepDoesNotStandInTheNext() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    answer(fields(practice).first(), "30");
    practice.setStep("lesson", 1, {});
    practice.setWorking(someWorking(), false);
    QCOMPARE(fields(practice).size(), 1);
    QVERIFY(fields(practice).first()->text().isEmpty());
    QVERIFY(text(line(practice, 1).remark).isEmpty());
  }

  void openQuestionHidesTheNumbersAndAsksForNone() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    QTest::mouseClick(button(practice, "All blank"), Qt::LeftButton);
    practice.setWorking(someWorking(), true);
    QVERIFY(fields(practice).isEmpty());
    QVERIFY(!practice.hasBlanks());
    QVERIFY(!practice.panel().latexOfAll().contains("30"));
    QVERIFY(!button(practice, "All blank")->isEnabled());
    QVERIFY(!button(practice, "New numbers")->isEnabled());
  }

  void fieldThatGetsTheFocusComesIntoView() {
    WorkingPractice practice(m_typesetter);
    show(practice);
    practice.resize(300, 220);
    practice.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&practice));
    QTest::mouseClick(button(practice, "Last blank"), Qt::LeftButton);
    QTRY_VERIFY(practice.panel().verticalScrollBar()->value() > 0);
    const QLineEdit *field = fields(practice).first();
    const QRect inView(field->mapTo(practice.panel().viewport(), QPoint()), field->size());
    QVERIFY(practice.panel().viewport()->rect().contains(inView));
  }
};

QTEST_MAIN(WorkingPracticeTest)
#include "working_practice_test.moc"
