// The worked lines: where their formulas stand, and what the pointer finds there.
#include "tests/lessons/called_line.h"
#include "tests/widgets/working/working_block_fixture.h"

#include "widgets/picture/term_formula.h"

#include <QClipboard>
#include <QScrollBar>
#include <QSignalSpy>

using namespace halfspace;
using test::called;
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
QPointF middleOf(const WorkingBlock &panel, std::size_t line, const QString &mark) {
  const PlacedFormula formula = panel.placed().lines[line].formulas.front();
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
    WorkingBlock panel(m_typesetter);
    show(panel, 900, someWorking());
    const auto placed = panel.placed();
    QCOMPARE(placed.lines.size(), std::size_t(2));
    QCOMPARE(placed.lines[0].formulas.size(), std::size_t(3));
    for (const PlacedFormula &formula : placed.lines[0].formulas)
      QCOMPARE(formula.baseline.y(), placed.lines[0].formulas[0].baseline.y());
    QVERIFY(placed.lines[0].formulas[0].box().right() < placed.lines[0].formulas[1].box().left());
    QVERIFY(placed.lines[0].sentence.front().baseline.y() > placed.lines[0].formulas[0].box().bottom());
  }

  void narrowLineBreaksBeforeAPieceAndStaysInside() {
    WorkingBlock panel(m_typesetter);
    show(panel, 270, someWorking());
    for (const PlacedLine &line : panel.placed().lines)
      for (const PlacedFormula &formula : line.formulas)
        QVERIFY(formula.box().right() <= 270);
    const auto formulas = panel.placed().lines[1].formulas;
    QVERIFY(formulas[1].box().top() >= formulas[0].box().bottom());
    QVERIFY(formulas[1].box().left() > formulas[0].box().left());
  }

  void formulaThatFitsNowhereIsBrokenBetweenItsSummands() {
    WorkingBlock panel(m_typesetter);
    show(panel, 300, {{called("a", line(longSum(60))), called("b", line(unknown("x")))}});
    const auto placed = panel.placed();
    const PlacedFormula &broken = placed.lines[0].formulas[0];
    QCOMPARE(broken.emPixels, placed.lines[1].formulas[0].emPixels);
    QVERIFY(broken.box().right() <= 300);
    QVERIFY(broken.box().height() > 5 * placed.lines[1].formulas[0].box().height());
    QVERIFY(placed.lines[0].box.bottom() >= broken.box().bottom());
  }

  void formulaThatCannotBeBrokenIsSmallerButReadableAndCanBeScrolledTo() {
    WorkingBlock panel(m_typesetter);
    show(panel, 300, {{called("a", line(root(longSum(60)))), called("b", line(unknown("x")))}});
    const auto placed = panel.placed();
    QCOMPARE(placed.lines[0].formulas[0].emPixels, 0.6 * placed.lines[1].formulas[0].emPixels);
    QVERIFY(placed.size.width() > 300);
  }

  void pointerOnATermTellsItsMarkAndLeavingTellsNone() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, someWorking());
    QSignalSpy hovered(&panel, &WorkingBlock::markHovered);
    movePointer(panel, middleOf(panel, 0, "P0"));
    QCOMPARE(hovered.takeLast().at(0).toString(), QString("P0"));
    movePointer(panel, middleOf(panel, 1, "r"));
    QCOMPARE(hovered.takeLast().at(0).toString(), QString("r"));
    movePointer(panel, middleOf(panel, 1, "r") + QPointF(1, 1));
    QVERIFY(hovered.isEmpty()); // still the same
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(panel.viewport(), &leave);
    QCOMPARE(hovered.takeLast().at(0).toString(), QString());
  }

  void pointerFindsTermsInAScrolledPanel() {
    WorkingBlock panel(m_typesetter);
    show(panel, 270, someWorking());
    panel.resize(270, 120);
    panel.verticalScrollBar()->setValue(panel.verticalScrollBar()->maximum());
    QVERIFY(panel.verticalScrollBar()->value() > 0);
    QSignalSpy hovered(&panel, &WorkingBlock::markHovered);
    movePointer(panel, middleOf(panel, 1, "Q"));
    QCOMPARE(hovered.takeLast().at(0).toString(), QString("Q"));
  }

  void highlightedTermHasABackground() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, someWorking());
    const QPoint beside = middleOf(panel, 0, "P0").toPoint() + QPoint(0, -9);
    const QColor before = panel.viewport()->grab().toImage().pixelColor(beside);
    panel.setHighlighted({"P0"});
    QVERIFY(panel.viewport()->grab().toImage().pixelColor(beside) != before);
  }

  void blankedLineShowsNoNumbersAnywhere() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, someWorking());
    panel.setWorking(someWorking(), blankIn(someWorking(), "t"));
    // The symbols, = with the field, and what is told of their names.
    QCOMPARE(panel.placed().lines[0].formulas.size(), std::size_t(3));
    QVERIFY(!panel.placed().lines[0].blank.isNull());
    QCOMPARE(panel.placed().lines[1].formulas.size(), std::size_t(3));
    const QString firstLine = panel.accessibleDescription().split('\n').front();
    QVERIFY(!firstLine.contains("30"));
    QVERIFY(!firstLine.contains("So many steps"));
    QVERIFY(!panel.latexOfAll().split('\n').front().contains("30"));
    panel.setWorking(someWorking());
    QVERIFY(panel.accessibleDescription().split('\n').front().contains("30"));
  }

  void copyingGivesPlainLatexOfTheClickedLine() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, someWorking());
    QTest::mouseClick(panel.viewport(), Qt::LeftButton, Qt::NoModifier,
                      panel.placed().lines[0].box.center().toPoint());
    QTest::keyClick(&panel, Qt::Key_C, Qt::ControlModifier);
    const QString copied = QApplication::clipboard()->text();
    QVERIFY(copied.startsWith("t = \\frac{(P_0 - Q)"));
    QVERIFY(copied.endsWith("= -\\frac{10}{3}"));
    QVERIFY(!copied.contains("\\mark"));
  }

  void shownLinesAreThoseGivenLastAtOnce() {
    WorkingBlock panel(m_typesetter);
    panel.resize(900, 500);
    for (int i = 0; i < 20; ++i) {
      const Term a = name(letter("a"), Rational(i * i, 7));
      const WorkingLine shownLine =
          called("a", line({withNumbers(a == power(name(letter("b"), Rational(i)), 2) / 7)}));
      panel.setWorking({{shownLine, shownLine}});
      const auto placed = panel.placed();
      QCOMPARE(placed.lines.size(), std::size_t(2));
      for (const PlacedLine &shown : placed.lines) {
        QCOMPARE(shown.formulas[1].picture->box(),
                 m_typesetter.picture(formulaOf(shownLine, LinePiece::Numbers).row)->box());
        QCOMPARE(shown.formulas.back().picture->box(),
                 m_typesetter.picture(formulaOf(shownLine, LinePiece::Result).row)->box());
      }
      QVERIFY(panel.accessibleDescription().contains(QString::number(i)));
    }
  }
};

QTEST_MAIN(WorkingBlockTest)
#include "working_block_test.moc"
