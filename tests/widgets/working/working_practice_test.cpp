// Worked lines that the learner fills in, with real keys and clicks.
#include "tests/lessons/called_line.h"
#include "tests/lessons/spoken_to_in.h"
#include "tests/widgets/working/told_latex.h"
#include "widgets/working/working_practice.h"

#include "lessons/object/object.h"
#include "lessons/term/rewrite.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>
#include <QVBoxLayout>
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

QToolButton *button(const QWidget &widget, const QString &text) {
  for (QToolButton *found : widget.findChildren<QToolButton *>())
    if (found->text() == text && found->isVisibleTo(&widget))
      return found;
  return nullptr;
}

QString text(const std::vector<PlacedText> &pieces) {
  QString all;
  for (const PlacedText &piece : pieces)
    all += piece.text;
  return all;
}

/// The tools above a block of lines, as on a page.
class ShownPractice : public QWidget {
public:
  explicit ShownPractice(const Typesetter &typesetter)
      : tools(typesetter), m_block(*tools.working().addBlock()) {
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(&tools);
    layout->addWidget(&m_block);
    resize(500, 700);
    show();
    setStep(0);
    setWorking(someWorking());
  }

  void setStep(int step, std::optional<Fading> asked = {}) { tools.setStep("lesson", step, asked); }
  void setWorking(const Working &working, bool hidden = false) {
    tools.setWorking(working, {working.lines.size()}, hidden);
  }
  /// Chooses from the menu, as by a click there.
  void choose(const QString &fading) {
    for (QAction *choice : chooser().menu()->actions())
      if (choice->text() == fading)
        return choice->trigger();
    QTest::qFail(qPrintable("no " + fading), __FILE__, __LINE__);
  }
  [[nodiscard]] QToolButton &chooser() const { return *tools.findChild<QToolButton *>("fading"); }
  [[nodiscard]] QToolButton &newNumbers() const { return *tools.findChild<QToolButton *>("newNumbers"); }
  [[nodiscard]] QString score() const {
    const auto *label = tools.findChild<QLabel *>("score");
    return label->isVisibleTo(this) ? label->text() : QString();
  }
  /// The fields to be filled in, from top to bottom.
  [[nodiscard]] QList<QLineEdit *> fields() const {
    QList<QLineEdit *> shown;
    for (QLineEdit *field : m_block.findChildren<QLineEdit *>())
      if (field->isVisibleTo(this) && field->isEnabled())
        shown << field;
    std::sort(shown.begin(), shown.end(), [](const QLineEdit *a, const QLineEdit *b) {
      return a->parentWidget()->y() < b->parentWidget()->y();
    });
    return shown;
  }
  [[nodiscard]] const PlacedLine &line(std::size_t index) const { return m_block.placed().lines.at(index); }
  [[nodiscard]] const WorkingBlock &block() const { return m_block; }

  WorkingPractice tools;

private:
  WorkingBlock &m_block;
};

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

private slots:
  void allLinesAreShownUntilTheLearnerChooses() {
    ShownPractice practice(m_typesetter);
    QVERIFY(!practice.tools.hasBlanks());
    QVERIFY(practice.fields().isEmpty());
    QCOMPARE(practice.chooser().text(), QString("Practise"));
    QSignalSpy changed(&practice.tools, &WorkingPractice::blanksChanged);
    practice.choose("Last blank");
    QCOMPARE(changed.count(), 1);
    QVERIFY(practice.tools.hasBlanks());
    QCOMPARE(practice.fields().size(), 1);
    QVERIFY(practice.line(0).blank.isNull());
    QVERIFY(!practice.line(1).blank.isNull());
    QVERIFY(practice.line(2).blank.isNull());                   // it asks for nothing …
    QCOMPARE(practice.line(2).formulas.size(), std::size_t(1)); // … but waits with its numbers
    QVERIFY(!latexIn(practice.block()).contains("10"));
    QVERIFY(text(practice.line(1).sentence).isEmpty());
  }

  void wrongAnswerIsToldByItsMistakeAndTheRightOneOpensTheLine() {
    ShownPractice practice(m_typesetter);
    practice.choose("Last blank");
    QSignalSpy reached(&practice.tools.working(), &StepWorking::reached);
    answer(practice.fields().first(), "30");
    QCOMPARE(text(practice.line(1).remark), QString("30 is f(Q)."));
    QVERIFY(practice.tools.hasBlanks());
    QCOMPARE(reached.last().at(1).toRect(), practice.line(1).box.toAlignedRect());
    answer(practice.fields().first(), "10");
    QVERIFY(!practice.tools.hasBlanks());
    QVERIFY(practice.fields().isEmpty());
    QCOMPARE(text(practice.line(1).remark), QString("Right."));
    QCOMPARE(text(practice.line(1).sentence), QString("Divided by the length."));
    QVERIFY(latexIn(practice.block()).contains("= 10"));
  }

  void practisingIsOfferedOnlyWhereANumberIsWorkedOut() {
    ShownPractice practice(m_typesetter);
    QVERIFY(practice.chooser().isEnabled());
    practice.setWorking({{WorkingLine{"a", {Chain(unknown("x"))}}}});
    QVERIFY(!practice.chooser().isEnabled());
    QVERIFY(practice.newNumbers().isEnabled());
  }

  void answerIsReadAndToldInTheLanguageOfTheLearner() {
    ShownPractice practice(m_typesetter);
    const test::SpokenToIn german(test::withDecimalComma());
    Working working = someWorking();
    working.lines.push_back(
        called("G", asked(withResult(name(letter("G"), ExactVec3(Rational(3, 2), 2, 3))))));
    practice.setWorking(working);
    practice.choose("Last blank");
    answer(practice.fields().first(), "1,25");
    QVERIFY(text(practice.line(3).remark).contains("(1; 2; 3)")); // so many are asked for …
    answer(practice.fields().first(), "(1, 2, 3)");
    QVERIFY(text(practice.line(3).remark).contains("(1, 2, 3) is not right")); // … and these can be typed
    answer(practice.fields().first(), "(1,5; 2; 3)");
    QCOMPARE(text(practice.line(3).remark), QString("Right."));
  }

  void rightAnswerHandsTheKeysToTheNextField() {
    ShownPractice practice(m_typesetter);
    practice.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&practice));
    practice.choose("All blank");
    QCOMPARE(practice.fields().size(), 2);
    QTRY_VERIFY(practice.fields().first()->hasFocus());
    answer(practice.fields().first(), "30");
    QCOMPARE(practice.fields().size(), 1);
    QTRY_VERIFY(practice.fields().first()->hasFocus());
  }

  void showButtonRevealsALineWithoutAnAnswer() {
    ShownPractice practice(m_typesetter);
    practice.choose("All blank");
    QCOMPARE(practice.line(2).formulas.size(), std::size_t(1));
    QTest::mouseClick(button(practice, "Show"), Qt::LeftButton);
    QTest::mouseClick(button(practice, "Show"), Qt::LeftButton);
    QVERIFY(!practice.tools.hasBlanks());
    QCOMPARE(practice.line(2).formulas.size(), std::size_t(2)); // it has waited
  }

  void gapStandsInTheFormulaAndAsksForThatNumber() {
    ShownPractice practice(m_typesetter);
    practice.choose("Gaps");
    QVERIFY(practice.tools.hasBlanks());
    const PlacedLine distance = practice.line(1); // h = f(Q)/3 = 30/3 = 10, without one of its numbers
    QVERIFY(!distance.blank.isNull());
    QCOMPARE(distance.formulas.size(), std::size_t(3));
    const auto holder = std::find_if(distance.formulas.begin(), distance.formulas.end(),
                                     [](const PlacedFormula &formula) { return formula.picture->leftOut(); });
    QVERIFY(holder != distance.formulas.end());
    QVERIFY(holder->box().adjusted(-1, -1, 1, 1).contains(distance.blank));
    QLineEdit *field = practice.fields().front();
    QVERIFY(distance.blank.toAlignedRect()
                .adjusted(-1, -1, 1, 1)
                .contains(QRect(field->mapTo(&practice.block(), QPoint()), field->size())));
    QVERIFY(text(distance.sentence).isEmpty());
    const QString question = field->accessibleName();
    QVERIFY2(question.contains('?'), qPrintable(question));
    answer(field, "10"); // 30 is what the line above comes to
    QVERIFY(practice.line(1).blank.isNull());
    QCOMPARE(text(practice.line(1).remark), QString("Right."));
  }

  void whatNoLineSaysIsToldWhereItIsNeeded() {
    ShownPractice practice(m_typesetter);
    const Working all = someWorking();
    practice.setWorking({{all.lines[1]}});
    practice.choose("Last blank");
    QCOMPARE(practice.line(0).formulas.size(), std::size_t(3)); // h = f(Q)/3, = and the field, f(Q) = 30
    QVERIFY(practice.line(0).formulas.back().box().top() > practice.line(0).blank.top());
    practice.setWorking({{all.lines[0], all.lines[1]}});
    QCOMPARE(practice.line(1).formulas.size(), std::size_t(2));
  }

  void changedSceneKeepsTheBlankAndAsksForTheNewNumber() {
    ShownPractice practice(m_typesetter);
    practice.choose("Last blank");
    answer(practice.fields().first(), "30");
    practice.setWorking(someWorking(60));
    QCOMPARE(text(practice.line(1).remark), QString("Before the change: 30 is f(Q)."));
    QCOMPARE(practice.fields().first()->property("wrong").toBool(), false);
    QVERIFY(practice.tools.hasBlanks());
    answer(practice.fields().first(), "10");
    QVERIFY(practice.tools.hasBlanks());
    answer(practice.fields().first(), "20");
    QVERIFY(!practice.tools.hasBlanks());
    practice.setWorking(someWorking(60));
    QVERIFY(!practice.tools.hasBlanks()); // the same numbers are not asked twice
    practice.setWorking(someWorking(90));
    QVERIFY(practice.tools.hasBlanks()); // new numbers are
    answer(practice.fields().first(), "30");
    QVERIFY(!practice.tools.hasBlanks());
  }

  void questionThatIsOpenedAgainKeepsWhatIsFilledIn() {
    ShownPractice practice(m_typesetter);
    practice.choose("Last blank");
    answer(practice.fields().first(), "10");
    QVERIFY(!practice.tools.hasBlanks());
    practice.setWorking(someWorking(60), true); // it shows the lines of other numbers
    practice.setWorking(someWorking());
    QVERIFY(!practice.tools.hasBlanks());
  }

  void newNumbersBlankAllLinesAgainAndGiveTheFocusToTheFirst() {
    ShownPractice practice(m_typesetter);
    practice.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&practice));
    int asked = 0;
    connect(&practice.tools, &WorkingPractice::newNumbersRequested, this, [&] {
      ++asked;
      practice.setWorking(someWorking(60));
    });
    QTest::mouseClick(&practice.newNumbers(), Qt::LeftButton);
    QCOMPARE(asked, 1);
    QVERIFY(practice.fields().isEmpty());
    practice.choose("All blank");
    answer(practice.fields().first(), "60");
    answer(practice.fields().first(), "7"); // wrong
    QCOMPARE(practice.fields().size(), 1);
    QTest::mouseClick(&practice.newNumbers(), Qt::LeftButton);
    QCOMPARE(asked, 2);
    QCOMPARE(practice.fields().size(), 2);
    for (const QLineEdit *field : practice.fields())
      QVERIFY(field->text().isEmpty());
    QVERIFY(text(practice.line(1).remark).isEmpty());
    QTRY_VERIFY(practice.fields().first()->hasFocus());
  }

  void scoreCountsWhatIsRightAtTheFirstTry() {
    ShownPractice practice(m_typesetter);
    QCOMPARE(practice.score(), QString());
    practice.choose("All blank");
    QCOMPARE(practice.score(), QString());    // nothing is tried yet
    answer(practice.fields().first(), "abc"); // no answer
    QCOMPARE(practice.score(), QString());
    answer(practice.fields().first(), "30");
    QCOMPARE(practice.score(), QString("Right 1/1"));
    answer(practice.fields().first(), "30"); // wrong
    answer(practice.fields().first(), "10");
    QCOMPARE(practice.score(), QString("Right 1/2"));
    practice.choose("Last blank");
    QCOMPARE(practice.score(), QString());
  }

  void scoreCountsWhatWasShownAsTried_andGoesOnWithOtherNumbers() {
    ShownPractice practice(m_typesetter);
    practice.choose("All blank");
    answer(practice.fields().first(), "30");
    QTest::mouseClick(button(practice, "Show"), Qt::LeftButton);
    QCOMPARE(practice.score(), QString("Right 1/2"));
    practice.setStep(1, Fading::All);
    practice.setWorking(someWorking());
    QCOMPARE(practice.score(), QString());
    practice.setStep(0);
    practice.setWorking(someWorking());
    QCOMPARE(practice.score(), QString("Right 1/2"));
    practice.setWorking(someWorking(), true);
    QCOMPARE(practice.score(), QString()); // a question goes before
    practice.setWorking(someWorking(60));
    QCOMPARE(practice.score(), QString("Right 1/2"));
    answer(practice.fields().first(), "60");
    QCOMPARE(practice.score(), QString("Right 2/3"));
    QTest::mouseClick(&practice.newNumbers(), Qt::LeftButton);
    answer(practice.fields().first(), "60");
    QCOMPARE(practice.score(), QString("Right 3/4"));
  }

  void choiceHoldsInTheStepsOfItsLesson_andInNoOther() {
    ShownPractice practice(m_typesetter);
    practice.choose("Last blank");
    practice.setStep(1);
    practice.setWorking(someWorking());
    QCOMPARE(practice.fields().size(), 1);
    practice.tools.setStep("another lesson", 0, {});
    practice.setWorking(someWorking());
    QVERIFY(!practice.tools.hasBlanks());
    QCOMPARE(practice.chooser().text(), QString("Practise"));
    practice.setStep(2);
    practice.setWorking(someWorking());
    QVERIFY(practice.tools.hasBlanks());
  }

  void choices_excludeEachOther_andTheToolSaysWhichHolds() {
    ShownPractice practice(m_typesetter);
    for (const char *chosen : {"Gaps", "Last blank", "All blank", "All lines"}) {
      practice.choose(chosen);
      QCOMPARE(practice.chooser().text(),
               QString(chosen) == "All lines" ? QString("Practise") : QString(chosen));
      QStringList checked;
      for (const QAction *choice : practice.chooser().menu()->actions())
        if (choice->isChecked())
          checked << choice->text();
      QCOMPARE(checked, QStringList{chosen});
    }
  }

  void firstAnswer_movesNothing_howeverNarrowThePageIs() {
    ShownPractice practice(m_typesetter);
    practice.choose("All blank");
    const int width = practice.chooser().sizeHint().width() + practice.newNumbers().sizeHint().width() + 20;
    const int height = practice.tools.heightForWidth(width);
    answer(practice.fields().first(), "30");
    QVERIFY(!practice.score().isEmpty());
    QCOMPARE(practice.tools.heightForWidth(width), height);
    practice.choose("All lines");
    QVERIFY(practice.tools.heightForWidth(width) < height);
  }

  void toolsAreNeverCutOff() {
    ShownPractice practice(m_typesetter);
    practice.choose("All blank");
    answer(practice.fields().first(), "30");
    QVERIFY(!practice.score().isEmpty());
    const int least = practice.tools.minimumSizeHint().width();
    for (const int width : {practice.tools.sizeHint().width(), least}) {
      practice.tools.resize(width, practice.tools.heightForWidth(width));
      practice.tools.grab(); // lays it out
      QRegion taken;
      for (const QWidget *tool :
           {static_cast<QWidget *>(practice.tools.findChild<QLabel *>("score")),
            static_cast<QWidget *>(&practice.chooser()), static_cast<QWidget *>(&practice.newNumbers())}) {
        QVERIFY(tool->width() >= tool->sizeHint().width());
        QVERIFY(practice.tools.rect().contains(tool->geometry()));
        QVERIFY(!taken.intersects(tool->geometry()));
        taken += tool->geometry();
      }
    }
  }

  void stepMayAskForBlanksAndTheLearnersChoiceGoesBefore() {
    ShownPractice practice(m_typesetter);
    practice.setStep(1, Fading::All);
    practice.setWorking(someWorking());
    QCOMPARE(practice.chooser().text(), QString("All blank"));
    QVERIFY(practice.tools.hasBlanks());
    practice.choose("All lines");
    QVERIFY(!practice.tools.hasBlanks());
    practice.setStep(2);
    practice.setWorking(someWorking());
    QVERIFY(!practice.tools.hasBlanks());
  }

  void whatWasTypedInOneStepDoesNotStandInTheNext() {
    ShownPractice practice(m_typesetter);
    practice.choose("Last blank");
    answer(practice.fields().first(), "30");
    practice.setStep(1);
    practice.setWorking(someWorking());
    QCOMPARE(practice.fields().size(), 1);
    QVERIFY(practice.fields().first()->text().isEmpty());
    QVERIFY(text(practice.line(1).remark).isEmpty());
  }

  void openQuestionHidesTheNumbersAndAsksForNone() {
    ShownPractice practice(m_typesetter);
    practice.choose("All blank");
    practice.setWorking(someWorking(), true);
    QVERIFY(practice.fields().isEmpty());
    QVERIFY(!practice.tools.hasBlanks());
    QVERIFY(!latexIn(practice.block()).contains("30"));
    QVERIFY(!practice.chooser().isEnabled());
    QVERIFY(!practice.newNumbers().isEnabled());
  }

  void fieldThatGetsTheFocus_isReached() {
    ShownPractice practice(m_typesetter);
    practice.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&practice));
    QSignalSpy reached(&practice.tools.working(), &StepWorking::reached);
    practice.choose("Last blank");
    QTRY_VERIFY(!reached.isEmpty());
    const QRectF blank = practice.line(1).blank;
    QVERIFY(QRectF(reached.last().at(1).toRect()).contains(blank));
  }
};

QTEST_MAIN(WorkingPracticeTest)
#include "working_practice_test.moc"
