// Where the formulas and sentences of a working are laid out.
#include "tests/lessons/called_line.h"
#include "widgets/working/working_layout.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QtTest>

using namespace halfspace;
using test::called;

namespace {

constexpr double wide = 4000;

QFont usualFont() {
  QFont font;
  font.setPixelSize(16);
  return font;
}
double em() { return emPixelsOf(usualFont()); }

QString text(const std::vector<PlacedText> &pieces) {
  QString all;
  for (const PlacedText &piece : pieces)
    all += piece.text;
  return all;
}

double right(const PlacedLine &line) {
  double right = 0;
  for (const PlacedFormula &formula : line.formulas)
    right = std::max(right, formula.box().right());
  return right;
}

} // namespace

class WorkingLayoutTest : public QObject {
  Q_OBJECT

private:
  const Typesetter m_typesetter;
  SentenceBreaker m_sentences;

  [[nodiscard]] TypesetLine line(const std::string &id, const std::vector<QString> &latex,
                                 const std::string &sentence = {}) const {
    TypesetLine made{called(id, WorkingLine{{}, {}, sentence})};
    for (std::size_t i = 0; i < latex.size(); ++i)
      made.pieces.at(i) = latex[i].isEmpty() ? nullptr : m_typesetter.picture(latex[i]);
    return made;
  }

  PlacedWorking place(const std::vector<TypesetLine> &lines, double width = wide,
                      const std::map<std::string, QString> &remarks = {}) {
    return placeWorking(lines, remarks, m_sentences, usualFont(), width);
  }

  PlacedWorking placeHeld(const std::vector<TypesetLine> &lines, const PlacedLine &stood, double width) {
    return placeWorking(lines, {}, m_sentences, usualFont(), width, {{lines[0].source.id, stood}});
  }

private slots:
  void linesFollowEachOtherWithoutAGap_asTallAsTheWorking() {
    const PlacedWorking placed = place({line("a", {"x", "=1"}, "One."), line("b", {"\\frac{x}{y}"}),
                                        line("c", {"z"}, "Words on their own lines.")},
                                       200);
    QCOMPARE(placed.lines.size(), std::size_t(3));
    double top = 0;
    for (const PlacedLine &each : placed.lines) {
      QCOMPARE(each.box.top(), top);
      QCOMPARE(each.box.width(), 200.0);
      for (const PlacedFormula &formula : each.formulas)
        QVERIFY(each.box.contains(formula.box()));
      for (const PlacedText &words : each.sentence)
        QVERIFY(words.baseline.y() > each.formulas.back().box().bottom() &&
                words.baseline.y() < each.box.bottom());
      top = each.box.bottom();
    }
    QCOMPARE(placed.size, QSizeF(200, top));
  }

  void workingWithoutLines_takesNoRoom() {
    QVERIFY(place({}).lines.empty());
    QCOMPARE(place({}).size.height(), 0.0);
  }

  void piecesOfARow_standOnOneBaseline_asFarApartAsBothSidesOfARelation() {
    const PlacedLine placed = place({line("a", {"\\frac{x}{y}", "=\\frac{1}{\\frac{2}{3}}", "=1"})}).lines[0];
    QCOMPARE(placed.formulas.size(), std::size_t(3));
    const double gap = placed.formulas[1].box().left() - placed.formulas[0].box().right();
    QVERIFY(gap > 0.1 * em() && gap < em());
    QCOMPARE(placed.formulas[2].box().left() - placed.formulas[1].box().right(), gap);
    for (const PlacedFormula &formula : placed.formulas) {
      QCOMPARE(formula.baseline.y(), placed.formulas[0].baseline.y());
      QCOMPARE(formula.emPixels, em());
    }
  }

  void missingPiece_leavesNoGap_andTheOthersKnowWhatTheyAre() {
    const PlacedLine all = place({line("a", {"x", "=1"})}).lines[0];
    const PlacedLine gapped = place({line("a", {"x", "", "=1"})}).lines[0];
    QCOMPARE(gapped.formulas.size(), std::size_t(2));
    QCOMPARE(gapped.formulas[1].box(), all.formulas[1].box());
    QVERIFY(gapped.formulas[0].piece == LinePiece::Symbols);
    QVERIFY(gapped.formulas[1].piece == LinePiece::Result);
    QVERIFY(all.formulas[1].piece == LinePiece::Numbers);
  }

  void pieceThatDoesNotFit_beginsAnIndentedRowBelowTheLast() {
    const std::vector<TypesetLine> lines{line("a", {"xxxxxxxxxx", "=yyyyyyyyyy", "=z"})};
    const double needed = right(place(lines).lines[0]);
    const PlacedLine fits = place(lines, needed + em() + 1).lines[0];
    QCOMPARE(fits.formulas[2].baseline.y(), fits.formulas[0].baseline.y());
    const PlacedLine broken = place(lines, needed + em() - 1).lines[0];
    QCOMPARE(broken.formulas[1].baseline.y(), broken.formulas[0].baseline.y());
    QVERIFY(broken.formulas[2].box().top() > broken.formulas[0].box().bottom());
    QVERIFY(broken.formulas[2].box().left() > broken.formulas[0].box().left());
    QVERIFY(broken.formulas[2].box().left() < broken.formulas[1].box().left());
  }

  void tallPiece_pushesItsRowDownButNotOnesAbove() {
    const double flat = place({line("a", {"x"})}).size.height();
    QCOMPARE(place({line("a", {"p"})}).size.height(), flat); // every row has room for ordinary letters
    const PlacedWorking placed = place({line("a", {"x"}), line("b", {"x", "=\\frac{\\frac12}{\\frac12}"})});
    QCOMPARE(placed.lines[0].box.height(), flat);
    QVERIFY(placed.lines[1].box.height() > flat + 0.5 * em());
  }

  void besideAFormulaOnSeveralLines_nothingStands() {
    const QString sum = "x" + QString("+x").repeated(30);
    const PlacedLine placed = place({line("a", {sum, "=y"})}, 300).lines[0];
    QVERIFY(placed.formulas[0].picture->isBroken());
    QVERIFY(placed.formulas[0].box().right() <= 300);
    QVERIFY(placed.formulas[1].box().top() >= placed.formulas[0].box().bottom());
  }

  void formulaThatCannotBeBroken_isSmallerAsItNeeds_butStillReadable() {
    const std::vector<TypesetLine> lines{line("a", {"\\sqrt{" + QString("x").repeated(40) + "}"})};
    const double natural = right(place(lines).lines[0]) - em();
    const PlacedWorking smaller = place(lines, 0.8 * natural + 2 * em());
    QVERIFY(std::abs(smaller.lines[0].formulas[0].emPixels - 0.8 * em()) < 0.01 * em());
    QVERIFY(right(smaller.lines[0]) <= smaller.size.width() - em() + 0.01);
    const PlacedWorking least = place(lines, 0.3 * natural);
    QCOMPARE(least.lines[0].formulas[0].emPixels, 0.6 * em());
    QVERIFY2(least.size.width() > 0.6 * natural, "it can be scrolled to");
  }

  void piecesOfALine_areAllAsSmallAsTheOneThatCannotBeBroken_andOtherLinesAreNot() {
    const QString root = "\\sqrt{" + QString("x").repeated(40) + "}";
    const std::vector<TypesetLine> lines{line("a", {"y", "=" + root, "=z"}), line("b", {"y"})};
    const double natural = right(place({line("a", {root})}).lines[0]);
    const PlacedWorking placed = place(lines, 0.8 * natural);
    QCOMPARE(placed.lines[0].formulas.size(), std::size_t(3));
    QVERIFY(placed.lines[0].formulas[1].emPixels < 0.9 * em());
    for (const PlacedFormula &formula : placed.lines[0].formulas)
      QCOMPARE(formula.emPixels, placed.lines[0].formulas[1].emPixels);
    QVERIFY(right(placed.lines[0]) <= placed.size.width() - em() + 0.01);
    QCOMPARE(placed.lines[1].formulas[0].emPixels, em());
  }

  void blankIsWhereTheFormulaLeavesItsRoom_asLargeAsWasAskedFor() {
    TypesetLine asked = line("a", {"x"});
    QVERIFY(place({asked}).lines[0].blank.isNull());
    const math::Room room{4, 1.1, 0.4};
    asked.pieces[2] = m_typesetter.picture(math::row(math::tagged(math::LeftOut{}, {math::Node{room}})));
    const PlacedLine placed = place({asked}).lines[0];
    QVERIFY(std::abs(placed.blank.width() - 4 * em()) < 0.01);
    QVERIFY(std::abs(placed.blank.height() - 1.5 * em()) < 0.01);
    QVERIFY(std::abs(placed.blank.bottom() - placed.formulas[0].baseline.y() - 0.4 * em()) < 0.01);
    QVERIFY(placed.blank.left() > placed.formulas[0].box().right());
    QVERIFY(placed.box.contains(placed.blank));
  }

  void whatIsTold_standsInARowOfItsOwn_andIsNoPiece() {
    TypesetLine told = line("a", {"x", "=1"});
    told.told = m_typesetter.picture("y=2");
    const PlacedLine placed = place({told}).lines[0];
    QCOMPARE(placed.formulas.size(), std::size_t(3));
    QVERIFY(!placed.formulas[2].piece);
    QVERIFY(placed.formulas[2].box().top() > placed.formulas[0].box().bottom());
  }

  void sentenceIsLeftOutOfALineThatIsPartial() {
    TypesetLine partial = line("a", {"x"}, "It tells the result.");
    QCOMPARE(text(place({partial}).lines[0].sentence), QString("It tells the result."));
    partial.isPartial = true;
    QVERIFY(place({partial}).lines[0].sentence.empty());
  }

  void remarkStandsBetweenFormulasAndSentence_withRoomForItsMark() {
    const PlacedWorking placed =
        place({line("a", {"x"}, "Words."), line("b", {"y"}, "Words.")}, wide, {{"b", "Not right."}});
    QVERIFY(placed.lines[0].remark.empty());
    const PlacedLine &remarked = placed.lines[1];
    QCOMPARE(text(remarked.remark), QString("Not right."));
    QVERIFY(remarked.remark[0].baseline.y() > remarked.formulas[0].box().bottom());
    QVERIFY(remarked.remark[0].baseline.y() < remarked.sentence[0].baseline.y());
    QVERIFY(remarked.remark[0].baseline.x() - remarked.sentence[0].baseline.x() > 10);
    QVERIFY(remarked.box.height() > placed.lines[0].box.height());
  }

  void longRemark_staysInsideTheWidth() {
    const QString words = QString("not right ").repeated(12);
    const PlacedLine placed = place({line("a", {"x"})}, 260, {{"a", words}}).lines[0];
    QVERIFY(placed.remark.size() > 3);
    for (const PlacedText &each : placed.remark)
      QVERIFY(each.baseline.x() + QFontMetricsF(usualFont()).horizontalAdvance(each.text.trimmed()) <= 260);
    QVERIFY(placed.box.bottom() > placed.remark.back().baseline.y());
  }

  void severalWorkings_standBelowEachOther_underTheirNames() {
    const PlacedWorking placed =
        place({line("first.a", {"x"}), line("first.b", {"y"}, "Words."), line("second.a", {"z"})});
    QCOMPARE(text(placed.lines[0].heading), QString("first"));
    QVERIFY(placed.lines[1].heading.empty());
    QCOMPARE(text(placed.lines[2].heading), QString("second"));
    QCOMPARE(placed.lines[2].box.left(), 0.0);
    QCOMPARE(placed.lines[2].box.top(), placed.lines[1].box.bottom());
    QVERIFY(placed.lines[2].heading[0].baseline.y() > placed.lines[2].box.top());
    QVERIFY(placed.lines[2].heading[0].baseline.y() < placed.lines[2].formulas[0].box().top());
  }

  void heldLine_keepsItsHeight() {
    const std::vector<TypesetLine> lines{line("a", {"x"}), line("b", {"y"})};
    PlacedLine stood = place(lines).lines[0];
    const double natural = stood.box.height();
    stood.box.setHeight(natural + 30);
    const PlacedWorking held = placeHeld(lines, stood, wide);
    QCOMPARE(held.lines[0].box.height(), natural + 30);
    QCOMPARE(held.lines[1].box.top(), natural + 30);
    QCOMPARE(held.lines[0].formulas[0].box(), place(lines).lines[0].formulas[0].box());
    stood.box.setHeight(natural - 3);
    QCOMPARE(placeHeld(lines, stood, wide).lines[0].box.height(), natural);
  }

  void heldLine_whoseNumbersBecomeLonger_keepsItsRows_inTheMarginAndThenInSmallerType() {
    const std::vector<TypesetLine> before{line("a", {"f = aaaaaaaa", "= bbbbbbbb"})};
    const double width = right(place(before).lines[0]) + em(); // with the usual margin
    const PlacedLine stood = place(before, width).lines[0];
    QVERIFY(!stood.formulas[1].beginsRow);

    const std::vector<TypesetLine> longer{line("a", {"f = aaaaaaaa", "= bbbbbbbbb"})};
    QVERIFY(place(longer, width).lines[0].formulas[1].beginsRow);
    const PlacedLine inMargin = placeHeld(longer, stood, width).lines[0];
    QVERIFY(!inMargin.formulas[1].beginsRow);
    QCOMPARE(inMargin.formulas[0].emPixels, em());
    QCOMPARE(inMargin.box, stood.box);

    const std::vector<TypesetLine> muchLonger{line("a", {"f = aaaaaaaa", "= bbbbbbbbbbbb"})};
    const PlacedLine smaller = placeHeld(muchLonger, stood, width).lines[0];
    QVERIFY(!smaller.formulas[1].beginsRow);
    QVERIFY(smaller.formulas[0].emPixels < em());
    QVERIFY(right(smaller) <= width);
    QCOMPARE(smaller.box, stood.box);
  }

  void heldLine_whosePiecesAreBrokenLess_leavesItsWordsWhereTheyAre() {
    const QString sum = "x" + QString("+x").repeated(30);
    const std::vector<TypesetLine> before{line("a", {"f=" + sum}, "Words.")};
    const double width = 12 * em();
    const PlacedLine stood = place(before, width).lines[0];
    QVERIFY(stood.formulas[0].picture->isBroken());
    const PlacedLine shorter = placeHeld({line("a", {"f=x"}, "Words.")}, stood, width).lines[0];
    QCOMPARE(shorter.sentence[0].baseline, stood.sentence[0].baseline);
    QCOMPARE(shorter.box, stood.box);
  }

  void heldLine_thatWouldBeTooSmallToRead_isLaidOutAnew() {
    const std::vector<TypesetLine> before{line("a", {"f = aaaa", "= bbbb"})};
    const double width = right(place(before).lines[0]) + em();
    const PlacedLine stood = place(before, width).lines[0];
    const std::vector<TypesetLine> tooLong{line("a", {"f = aaaaaaa", "= bbbbbbbb"})};
    const PlacedLine anew = placeHeld(tooLong, stood, width).lines[0];
    QVERIFY(anew.formulas[1].beginsRow);
    QCOMPARE(anew.formulas[1].emPixels, place(tooLong, width).lines[0].formulas[1].emPixels);
    QVERIFY(anew.box.height() > stood.box.height());
  }

  void heldLine_whoseNumbersBecomeShorter_keepsItsRows() {
    const std::vector<TypesetLine> before{line("a", {"f = aaaaaaaa", "= bbbbbbbb"})};
    const double width = right(place(before).lines[0]) - em();
    const PlacedLine stood = place(before, width).lines[0];
    QVERIFY(stood.formulas[1].beginsRow);
    const std::vector<TypesetLine> shorter{line("a", {"f = a", "= b"})};
    QVERIFY(placeHeld(shorter, stood, width).lines[0].formulas[1].beginsRow);
    QVERIFY(!place(shorter, width).lines[0].formulas[1].beginsRow);
  }

  void narrowestWidth_isWhereTheSmallestFormulaStillFits() {
    const std::vector<TypesetLine> lines{line("a", {"\\sqrt{" + QString("x").repeated(40) + "}"}),
                                         line("b", {"x" + QString("+x").repeated(60)})};
    const double narrowest = narrowestWidth(lines, usualFont());
    QCOMPARE(place(lines, narrowest).size.width(), narrowest);
    const double tooNarrow = narrowest - 2 * em();
    QVERIFY(place(lines, tooNarrow).size.width() > tooNarrow);
  }

  void oneWorking_hasNoHeadingAndAllTheWidth() {
    const PlacedWorking placed = place({line("only.a", {"x"}), line("only.b", {"y"})});
    QVERIFY(placed.lines[0].heading.empty() && placed.lines[1].heading.empty());
    QCOMPARE(placed.lines[1].box.width(), wide);
  }

  void boxesOfThePicture_areFoundWhereTheFormulaStands() {
    const PlacedFormula formula = place({line("a", {"x+\\mark{P}{y}"})}).lines[0].formulas[0];
    const QRectF mark = formula.toWorking(formula.picture->markBoxes().at(0).second);
    QVERIFY(formula.box().contains(mark));
    QVERIFY(std::abs(mark.right() - formula.box().right()) < 0.2 * em());
    QVERIFY(mark.left() > formula.box().center().x());
  }
};

QTEST_MAIN(WorkingLayoutTest)
#include "working_layout_test.moc"

#include <algorithm>
