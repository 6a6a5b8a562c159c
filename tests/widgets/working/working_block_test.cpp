// The worked lines: where their formulas stand, and what the pointer finds there.
#include "tests/widgets/working/told_latex.h"
#include "tests/widgets/working/working_block_fixture.h"

#include "lessons/lesson/new_numbers/new_numbers.h"
#include "lessons/lesson/shown.h"
#include "widgets/formula/term_formula.h"

#include <QAccessible>
#include <QClipboard>
#include <QSignalSpy>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// t = ((P0 − Q)·n)/(r·n) = −30/9 = −10/3, and the point H = Q + t r
Working someWorking() {
  const Term P0 = name(letter("P", "0"), ExactVec3(5, 4, 7)).marked("P0");
  const Term Q = name(letter("Q"), ExactVec3(11, 15, 8)).marked("Q");
  const Term n = name(vectorLetter("n"), ExactVec3(1, 2, 2)).marked("n");
  const Term r = name(vectorLetter("r"), ExactVec3(-1, 3, 2)).marked("r");
  const Term t = name(letter("t"), Rational(-10, 3));
  const Term H = name(letter("H"), ExactVec3(Rational(43, 3), 5, Rational(4, 3)));
  return {{called("t", line({withNumbers(t == dot(P0 - Q, n) / dot(r, n))},
                            "So many steps r lead from Q to the plane.")),
           called("H", line({withNumbers(H == Q + t * r)}, "The point where the ray meets the plane."))}};
}

/// x + x + …
Term longSum(int summands) {
  return sum(std::vector<Term>(static_cast<std::size_t>(summands), unknown("x")));
}

/// The middle of a mark's term in a line's first formula.
QPointF middleOf(const WorkingBlock &block, std::size_t line, const QString &mark) {
  const PlacedFormula formula = block.placed().lines[line].formulas.front();
  for (const auto &[id, box] : formula.picture->markBoxes())
    if (id == mark)
      return formula.toWorking(box).center();
  return {};
}

} // namespace

class WorkingBlockTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void wideLineKeepsItsPiecesInOneRow() {
    WorkingBlock block(m_typesetter);
    show(block, 900, someWorking());
    const auto placed = block.placed();
    QCOMPARE(placed.lines.size(), std::size_t(2));
    QCOMPARE(placed.lines[0].formulas.size(), std::size_t(3));
    for (const PlacedFormula &formula : placed.lines[0].formulas)
      QCOMPARE(formula.baseline.y(), placed.lines[0].formulas[0].baseline.y());
    QVERIFY(placed.lines[0].formulas[0].box().right() < placed.lines[0].formulas[1].box().left());
    QVERIFY(placed.lines[0].sentence.front().baseline.y() > placed.lines[0].formulas[0].box().bottom());
  }

  void linesOfNewNumbersInEveryLesson_fitOnThePage() {
    constexpr int usualPage = 370; // in pixels, without its margins
    WorkingBlock block(m_typesetter);
    for (const Lesson &lesson : readLessons(TEST_LESSONS_FOLDER).lessons)
      for (const LessonStep &step : lesson.steps)
        for (const std::uint64_t seed : {1U, 2U}) {
          const Scene scene = withNewNumbers(lesson.scene, step, lesson.camera.from, seed);
          block.setWorking(shownIn(step, evaluate(scene)).working);
          QVERIFY2(block.minimumSizeHint().width() <= usualPage,
                   (lesson.id + ", " + step.title + ": " + std::to_string(block.minimumSizeHint().width()))
                       .c_str());
        }
  }

  void narrowLineBreaksBeforeAPieceAndStaysInside() {
    WorkingBlock block(m_typesetter);
    show(block, 270, someWorking());
    for (const PlacedLine &line : block.placed().lines)
      for (const PlacedFormula &formula : line.formulas)
        QVERIFY(formula.box().right() <= 270);
    const auto formulas = block.placed().lines[1].formulas;
    QVERIFY(formulas[1].box().top() >= formulas[0].box().bottom());
    QVERIFY(formulas[1].box().left() > formulas[0].box().left());
  }

  void formulaThatFitsNowhereIsBrokenBetweenItsSummands() {
    WorkingBlock block(m_typesetter);
    show(block, 300, {{called("a", line(longSum(60))), called("b", line(unknown("x")))}});
    const auto placed = block.placed();
    const PlacedFormula &broken = placed.lines[0].formulas[0];
    QCOMPARE(broken.emPixels, placed.lines[1].formulas[0].emPixels);
    QVERIFY(broken.box().right() <= 300);
    QVERIFY(broken.box().height() > 5 * placed.lines[1].formulas[0].box().height());
    QVERIFY(placed.lines[0].box.bottom() >= broken.box().bottom());
  }

  void formulaThatCannotBeBrokenIsSmallerButReadableAndTheBlockAsksForItsRoom() {
    WorkingBlock block(m_typesetter);
    show(block, 300, {{called("a", line(root(longSum(60)))), called("b", line(unknown("x")))}});
    const auto placed = block.placed();
    QCOMPARE(placed.lines[0].formulas[0].emPixels, 0.6 * placed.lines[1].formulas[0].emPixels);
    QVERIFY(placed.size.width() > 300);
    QVERIFY(block.minimumSizeHint().width() >= placed.size.width());
  }

  void pointerOnATermTellsItsMarkAndLeavingTellsNone() {
    WorkingBlock block(m_typesetter);
    show(block, 900, someWorking());
    QSignalSpy hovered(&block, &WorkingBlock::markHovered);
    movePointer(block, middleOf(block, 0, "P0").toPoint());
    QCOMPARE(hovered.takeLast().at(0).toString(), QString("P0"));
    movePointer(block, middleOf(block, 1, "r").toPoint());
    QCOMPARE(hovered.takeLast().at(0).toString(), QString("r"));
    movePointer(block, (middleOf(block, 1, "r") + QPointF(1, 1)).toPoint());
    QVERIFY(hovered.isEmpty()); // still the same
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&block, &leave);
    QCOMPARE(hovered.takeLast().at(0).toString(), QString());
  }

  void highlightedTermHasABackground() {
    WorkingBlock block(m_typesetter);
    show(block, 900, someWorking());
    const QPoint beside = middleOf(block, 0, "P0").toPoint() + QPoint(0, -9);
    const QColor before = block.grab().toImage().pixelColor(beside);
    block.setLook({.highlighted = {"P0"}});
    QVERIFY(block.grab().toImage().pixelColor(beside) != before);
  }

  void blankedLineShowsNoNumbersAnywhere() {
    WorkingBlock block(m_typesetter);
    show(block, 900, someWorking());
    block.setWorking(someWorking(), blankIn(someWorking(), "t"));
    // The symbols, = with the field, and what is told of their names.
    QCOMPARE(block.placed().lines[0].formulas.size(), std::size_t(3));
    QVERIFY(!block.placed().lines[0].blank.isNull());
    QCOMPARE(block.placed().lines[1].formulas.size(), std::size_t(3));
    const QString firstLine = block.spoken().split('\n').front();
    QVERIFY(!firstLine.contains("30"));
    QVERIFY(!firstLine.contains("So many steps"));
    QVERIFY(!latexIn(block).split('\n').front().contains("30"));
    block.setWorking(someWorking());
    QVERIFY(block.spoken().split('\n').front().contains("30"));
  }

  void screenReader_isToldTheLines_whichAreWrittenWhenItAsks() {
    WorkingBlock block(m_typesetter);
    show(block, 900, someWorking());
    QVERIFY(block.accessibleDescription().isEmpty()); // kept nowhere
    const QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(&block);
    QCOMPARE(spoken->text(QAccessible::Name), QString("Worked lines"));
    QVERIFY(spoken->text(QAccessible::Description).contains("30"));
    block.setWorking(someWorking(), blankIn(someWorking(), "t"));
    QCOMPARE(spoken->text(QAccessible::Description), block.spoken());
  }

  void hiddenBlock_setsItsLinesInTypeOnceItIsSeen() {
    QWidget page;
    auto *block = new WorkingBlock(m_typesetter);
    (new QVBoxLayout(&page))->addWidget(block);
    page.resize(900, 500);
    page.show();
    block->hide();
    block->setWorking(someWorking());
    QVERIFY(block->placed().lines.empty());
    QVERIFY(block->spoken().contains("30")); // whoever asks is told
    block->show();
    QCOMPARE(block->placed().lines.size(), std::size_t(2));
  }

  void blockIsAsTallAsItsLines_atEveryWidth() {
    WorkingBlock block(m_typesetter);
    for (const int width : {900, 270}) {
      show(block, width, someWorking());
      QCOMPARE(block.heightForWidth(width),
               static_cast<int>(std::ceil(block.placed().lines[1].box.bottom())));
    }
    QVERIFY(block.heightForWidth(270) > block.heightForWidth(900)); // it is asked before it is that wide
  }

  void blockShowsItsOwnLinesAlone() {
    WorkingBlock block(m_typesetter);
    block.resize(900, 500);
    const Working working = someWorking();
    for (std::size_t own = 0; own < 2; ++own) {
      block.setWorking(working, {}, {}, {own, own + 1});
      QCOMPARE(block.placed().lines.size(), std::size_t(1));
      QCOMPARE(latexIn(block), QString::fromStdString(latexOf(working.lines[own])));
      QVERIFY(!block.spoken().contains('\n'));
    }
    block.setWorking({{working.lines[0]}}, {}, {}, {0, 2}); // a line is gone
    QCOMPARE(block.placed().lines.size(), std::size_t(1));
    block.setWorking(working, {}, {}, {1, 1});
    QVERIFY(block.placed().lines.empty());
    QCOMPARE(block.heightForWidth(900), 0);
  }

  void whatIsToldToFillABlankInIsFoundInTheWholeWorking() {
    const Term f = name(letter("f"), Rational(30));
    const Working working{{called("f", line({withResult(f)})),
                           called("h", line({withNumbers(name(letter("h"), Rational(10)) == f / 3)}))}};
    WorkingBlock block(m_typesetter);
    block.resize(900, 500);
    block.setWorking(working, blankIn(working, "h"), {}, {1, 2});
    QCOMPARE(block.placed().lines[0].formulas.size(), std::size_t(2)); // the line above says what f is
    block.setWorking({{working.lines[1]}}, blankIn(working, "h"));
    QCOMPARE(block.placed().lines[0].formulas.size(), std::size_t(3));
  }

  void heldLinesBecomeHigherButNeverLessHigh_untilTheyAreLetGo() {
    WorkingBlock block(m_typesetter);
    const auto sums = [](int summands) {
      return Working{{called("a", line(longSum(summands))), called("b", line(unknown("x")))}};
    };
    const auto topOfSecond = [&] { return block.placed().lines[1].box.top(); };
    show(block, 300, sums(20));
    const double usual = topOfSecond();
    block.setHeld(true);
    block.setWorking(sums(2));
    QCOMPARE(topOfSecond(), usual);
    block.setWorking(sums(40));
    const double grown = topOfSecond();
    QVERIFY(grown > usual);
    block.setWorking(sums(2));
    QCOMPARE(topOfSecond(), grown);
    QCOMPARE(block.heightForWidth(300), static_cast<int>(std::ceil(block.placed().lines[1].box.bottom())));
    block.setHeld(false);
    QVERIFY(topOfSecond() < usual);
  }

  void copyingGivesPlainLatexOfTheClickedLine() {
    WorkingBlock block(m_typesetter);
    show(block, 900, someWorking());
    QTest::mouseClick(&block, Qt::LeftButton, Qt::NoModifier, block.placed().lines[0].box.center().toPoint());
    QTest::keyClick(&block, Qt::Key_C, Qt::ControlModifier);
    const QString copied = QApplication::clipboard()->text();
    QVERIFY(copied.startsWith("t = \\frac{(P_0 - Q)"));
    QVERIFY(copied.endsWith("= -\\frac{10}{3}"));
    QVERIFY(!copied.contains("\\mark"));
  }

  void copyingWithoutAClickedLineGivesAllWithTheirSentences() {
    WorkingBlock block(m_typesetter);
    show(block, 900, someWorking());
    QTest::keyClick(&block, Qt::Key_C, Qt::ControlModifier);
    const QString copied = QApplication::clipboard()->text();
    QVERIFY(copied.startsWith("\\begin{align*}\n  t &= "));
    QVERIFY(copied.contains("\\intertext{So many steps r lead from Q to the plane.}\n  H &= "));
    QVERIFY(copied.endsWith("\\end{align*}\nThe point where the ray meets the plane.\n"));
  }

  void shownLinesAreThoseGivenLastAtOnce() {
    WorkingBlock block(m_typesetter);
    block.resize(900, 500);
    for (int i = 0; i < 20; ++i) {
      const Term a = name(letter("a"), Rational(i * i, 7));
      const WorkingLine shownLine =
          called("a", line({withNumbers(a == power(name(letter("b"), Rational(i)), 2) / 7)}));
      block.setWorking({{shownLine, shownLine}});
      const auto placed = block.placed();
      QCOMPARE(placed.lines.size(), std::size_t(2));
      for (const PlacedLine &shown : placed.lines) {
        QCOMPARE(shown.formulas[1].picture->box(),
                 m_typesetter.picture(formulaOf(shownLine, LinePiece::Numbers).row)->box());
        QCOMPARE(shown.formulas.back().picture->box(),
                 m_typesetter.picture(formulaOf(shownLine, LinePiece::Result).row)->box());
      }
      QVERIFY(block.spoken().contains(QString::number(i)));
    }
  }

  void blank_whateverTheSizeOfType_keepsItsFieldAndTheWordOfItsButton() {
    const Typesetter typesetter;
    WorkingBlock block(typesetter);
    const int usual = block.font().pointSize();
    show(block, 300, {});
    block.setWorking(tracedWorking(), blankIn(tracedWorking(), "a"));
    const auto &button = *block.findChild<QToolButton *>("showLine");
    for (const int percent : {100, 192, 250}) {
      const int before = button.height();
      block.setStyleSheet(
          QString("* { font-size: %1pt } QToolButton { padding: 0.3em 0.5em }").arg(usual * percent / 100));
      QTRY_VERIFY(button.height() > before); // the style comes to the fields after the block
      const QRect room(button.mapTo(&block, QPoint()), button.size());
      QVERIFY2(room.left() >= 0 && room.right() < block.width(), qPrintable(QString::number(percent)));
      QVERIFY(button.width() >= button.sizeHint().width());
      QVERIFY(button.height() >= button.sizeHint().height());
    }
  }
};

QTEST_MAIN(WorkingBlockTest)
#include "working_block_test.moc"
