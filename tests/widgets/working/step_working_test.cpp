// The worked lines of a step in two blocks: who shows which, what goes on in one and is seen in the other.
#include "widgets/working/step_working.h"

#include "tests/widgets/working/told_latex.h"
#include "tests/widgets/working/working_block_fixture.h"

#include <QLabel>
#include <QSignalSpy>
#include <QVBoxLayout>

using namespace halfspace;
using namespace halfspace::test;

namespace {

using Ids = std::set<std::string>;

/// Two blocks with words between them, as on a page.
class ShownBlocks {
public:
  explicit ShownBlocks(const Working &working, std::vector<std::size_t> linesIn = {1, 2})
      : lines(m_typesetter) {
    auto *layout = new QVBoxLayout(&m_page);
    for (int i = 0; i < 2; ++i) {
      layout->addWidget(lines.addBlock());
      layout->addWidget(new QLabel("Words."));
    }
    m_page.resize(900, 600);
    m_page.show();
    lines.setWorking(working, linesIn);
  }

  WorkingBlock &first() { return *lines.blocks()[0]; }
  WorkingBlock &second() { return *lines.blocks()[1]; }
  /// Waits until the blocks have their places.
  void layOut() {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QCoreApplication::processEvents();
  }
  QWidget *focused() { return m_page.focusWidget(); }
  bool isActive() {
    m_page.activateWindow();
    return QTest::qWaitForWindowActive(&m_page);
  }

private:
  Typesetter m_typesetter;

public:
  StepWorking lines;

private:
  QWidget m_page; // goes first, and its blocks with it
};

QStringList spokenIn(const WorkingBlock &block) { return block.spoken().split('\n', Qt::SkipEmptyParts); }

/// The middle of a line's lower edge, where nothing is written.
QPoint below(const WorkingBlock &block, std::size_t line) {
  return {block.width() / 2, static_cast<int>(block.placed().lines[line].box.bottom()) - 3};
}

} // namespace

class StepWorkingTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void blocksThatAreDropped_leaveNoTermHovered() {
    ShownBlocks shown(tracedWorking());
    QSignalSpy hovered(&shown.lines, &StepWorking::markHovered);
    emit shown.lines.blocks().front()->markHovered("Q");
    shown.lines.dropBlocks();
    QCOMPARE(hovered.count(), 2);
    QCOMPARE(hovered.back().front().toString(), QString());
    shown.lines.dropBlocks(); // nothing was hovered
    QCOMPARE(hovered.count(), 2);
  }

  void lines_goToTheBlocksInTheirOrder_soManyToEach() {
    ShownBlocks shown(tracedWorking());
    QCOMPARE(spokenIn(shown.first()).size(), 1);
    QCOMPARE(spokenIn(shown.second()).size(), 2);
    QVERIFY(spokenIn(shown.second())[0].startsWith("a equals"));
    shown.lines.setWorking(tracedWorking(), {2, 1});
    QCOMPARE(spokenIn(shown.first()).size(), 2);
    QVERIFY(spokenIn(shown.second())[0].startsWith("b equals"));
  }

  void block_withoutLines_isNotThereUntilItHasSome() {
    ShownBlocks shown(tracedWorking(), {3, 0});
    QVERIFY(shown.first().isVisible() && !shown.second().isVisible());
    shown.lines.setWorking(tracedWorking(), {2, 1});
    shown.lines.setWorking(tracedWorking(), {3}); // nothing is said about the second
    QVERIFY(!shown.second().isVisible());
    QVERIFY(shown.second().placed().lines.empty());
    shown.lines.setWorking(tracedWorking(), {2, 1});
    QVERIFY(shown.second().isVisible());
  }

  void linesToTakeElsewhere_areThoseOfAllBlocksButHiddenOnes() {
    ShownBlocks shown(tracedWorking());
    QCOMPARE(shown.lines.toldLines().size(), std::size_t(3));
    QCOMPARE(shown.lines.toldLines()[1].line->id, std::string("a"));
    shown.second().hide();
    QCOMPARE(shown.lines.toldLines().size(), std::size_t(1));
    shown.second().show();
    shown.lines.setWorking(tracedWorking(), {0, 0});
    QVERIFY(shown.lines.toldLines().empty());
  }

  void numberClickedInOneBlock_lightsUpItsSourcesInTheOther() {
    ShownBlocks shown(tracedWorking());
    shown.layOut();
    QSignalSpy changed(&shown.lines, &StepWorking::traceChanged);
    const QImage firstBefore = shown.first().grab().toImage();
    const QImage secondBefore = shown.second().grab().toImage();
    const NumberPlace ten = numberIn(shown.second(), 0, "10");
    click(shown.second(), ten);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(shown.lines.traced().lines, Ids{"uu"});
    QCOMPARE(shown.lines.traced().marks, Ids{"u"});
    const QImage first = shown.first().grab().toImage();
    const QImage second = shown.second().grab().toImage();
    QVERIFY(first.pixelColor(below(shown.first(), 0)) != firstBefore.pixelColor(below(shown.first(), 0)));
    QCOMPARE(second.pixelColor(below(shown.second(), 1)), secondBefore.pixelColor(below(shown.second(), 1)));
    const QRect around(middleOf(shown.second(), ten) - QPoint(12, 12), QSize(24, 24));
    QVERIFY(second.copy(around) != secondBefore.copy(around));
  }

  void numbersOfDifferentLines_areTracedToTheirOwnMarks() {
    ShownBlocks shown(tracedWorking());
    click(shown.second(), numberIn(shown.second(), 1, "3"));
    QCOMPARE(shown.lines.traced().marks, Ids{"w"});
    QCOMPARE(shown.lines.traced().lines, Ids{});
    click(shown.first(), numberIn(shown.first(), 0, "2"));
    QCOMPARE(shown.lines.traced().marks, Ids{"u"});
    QVERIFY((shown.lines.traced().coordinates == std::vector<CoordinateSource>{{"L", 1, 1}}));
  }

  void trace_endsWithEscapeOrAClickBeside_inWhicheverBlock() {
    ShownBlocks shown(tracedWorking());
    shown.layOut();
    click(shown.second(), numberIn(shown.second(), 0, "10"));
    QTest::keyClick(&shown.first(), Qt::Key_Escape);
    QVERIFY(shown.lines.traced() == Provenance());
    click(shown.second(), numberIn(shown.second(), 0, "10"));
    QTest::mouseClick(&shown.first(), Qt::LeftButton, {}, below(shown.first(), 0));
    QVERIFY(shown.lines.traced() == Provenance());
  }

  void trace_followsItsPlace_intoAnotherBlockToo() {
    ShownBlocks shown(tracedWorking());
    click(shown.second(), numberIn(shown.second(), 0, "10"));
    shown.lines.setWorking(tracedWorking(4), {1, 2});
    QCOMPARE(shown.lines.traced().lines, Ids{"uu"});
    shown.lines.setWorking(tracedWorking(4), {2, 1});
    QCOMPARE(shown.lines.traced().lines, Ids{"uu"});
    Working without = tracedWorking();
    without.lines.erase(1);
    shown.lines.setWorking(without, {1, 1});
    QVERIFY(shown.lines.traced() == Provenance());
    shown.lines.setWorking(tracedWorking(3), {1, 2}); // it comes back with its place
    QCOMPARE(shown.lines.traced().lines, Ids{"uu"});
  }

  void number_isFollowedThroughLinesThatAreNotShown() {
    Working part = tracedWorking();
    part.lines.erase(0);
    ShownBlocks shown(part, {1, 1});
    shown.lines.setWholeWorking([] { return tracedWorking(); });
    click(shown.first(), numberIn(shown.first(), 0, "5"));
    QCOMPARE(shown.lines.traced().lines, Ids{"uu"});
    QCOMPARE(shown.lines.traced().marks, Ids{"u"});
  }

  void numbersOfABlankLine_canNeitherBeTouchedNorTraced() {
    ShownBlocks shown(tracedWorking());
    const NumberPlace result = numberIn(shown.second(), 0, "10");
    const QPoint at = middleOf(shown.second(), result);
    click(shown.second(), result);
    shown.lines.setWorking(tracedWorking(), {1, 2}, blankIn(tracedWorking(), "a"));
    QVERIFY(shown.lines.traced() == Provenance());
    QVERIFY(shown.second().shownNumbers().inLine(0).empty());
    QTest::mouseClick(&shown.second(), Qt::LeftButton, {}, at);
    QVERIFY(shown.lines.traced() == Provenance());
  }

  void withheldLines_showTheirSymbolsAlone() {
    ShownBlocks shown(tracedWorking());
    shown.lines.setWorking(tracedWorking(), {1, 2}, withheld(tracedWorking()));
    QVERIFY(shown.first().shownNumbers().inLine(0).empty());
    QVERIFY(shown.second().shownNumbers().inLine(0).empty());
    QCOMPARE(latexIn(shown.second()).count('='), 2);
    QVERIFY(!shown.second().spoken().contains("10"));
    QVERIFY(shown.first().spoken().endsWith("= ?")); // of u·u alone nobody would know
    QVERIFY(!shown.second().spoken().contains("?"));
  }

  void lastField_ofABlockThatIsFilledIn_handsTheKeysToTheNextBlock() {
    ShownBlocks shown(tracedWorking());
    QVERIFY(shown.isActive());
    Fade both = blankIn(tracedWorking(), "uu");
    const Fade second = blankIn(tracedWorking(), "a");
    both.gaps.insert(second.gaps.begin(), second.gaps.end());
    shown.lines.setWorking(tracedWorking(), {1, 2}, both);
    shown.lines.focusField();
    QVERIFY(shown.first().isAncestorOf(shown.focused()));
    shown.lines.setWorking(tracedWorking(), {1, 2}, second);
    QVERIFY(shown.second().isAncestorOf(shown.focused()));
    shown.lines.setWorking(tracedWorking(), {1, 2}, {});
    QCOMPARE(shown.focused(), static_cast<QWidget *>(&shown.second())); // there is none left
  }

  void blankLine_isLitUpWithoutItsNumbers() {
    ShownBlocks shown(tracedWorking());
    shown.lines.setWorking(tracedWorking(), {1, 2}, blankIn(tracedWorking(), "uu"));
    shown.layOut();
    const QColor before = shown.first().grab().toImage().pixelColor(below(shown.first(), 0));
    click(shown.second(), numberIn(shown.second(), 0, "10"));
    QCOMPARE(shown.lines.traced().lines, Ids{"uu"});
    QVERIFY(shown.first().grab().toImage().pixelColor(below(shown.first(), 0)) != before);
    QVERIFY(shown.first().shownNumbers().inLine(0).empty());
  }

  void heldBlocks_becomeHigherButNeverLessHigh_untilTheyAreLetGo() {
    const auto heightOf = [](WorkingBlock &block) { return block.heightForWidth(block.width()); };
    const auto sums = [](std::size_t summands) {
      const auto longSum = [&](std::size_t count) { return sum(std::vector<Term>(count, unknown("x"))); };
      return Working{{called("a", line(longSum(1))), called("b", line(longSum(summands)))}};
    };
    ShownBlocks shown(sums(100), {1, 1});
    shown.layOut();
    const int usual = heightOf(shown.second());
    shown.lines.setHeld(true);
    shown.lines.setWorking(sums(2), {1, 1});
    QCOMPARE(heightOf(shown.second()), usual);
    shown.lines.setWorking(sums(200), {1, 1});
    QVERIFY(heightOf(shown.second()) > usual);
    shown.lines.setHeld(false);
    shown.lines.setWorking(sums(2), {1, 1});
    QVERIFY(heightOf(shown.second()) < usual);
  }

  void block_addedWhileHeld_isHeldToo() {
    StepWorking lines(m_typesetter);
    lines.setHeld(true);
    const std::unique_ptr<WorkingBlock> block(lines.addBlock());
    block->resize(300, 100);
    lines.setWorking({{called("a", line(sum(std::vector<Term>(80, unknown("x")))))}}, {1});
    const int high = block->heightForWidth(300);
    lines.setWorking({{called("a", line(unknown("x")))}}, {1});
    QCOMPARE(block->heightForWidth(300), high);
  }

  void arrowKeys_goOnIntoTheNextBlockWithLines_andStopAtTheEnds() {
    ShownBlocks shown(tracedWorking());
    QSignalSpy reached(&shown.lines, &StepWorking::reached);
    const auto reachedBlock = [&] { return reached.takeLast().at(0).value<WorkingBlock *>(); };
    shown.first().setFocus();
    QTest::keyClick(&shown.first(), Qt::Key_Down);
    QCOMPARE(reachedBlock(), &shown.first());
    QTest::keyClick(&shown.first(), Qt::Key_Down);
    QCOMPARE(shown.focused(), &shown.second());
    QCOMPARE(reachedBlock(), &shown.second());
    QTest::keyClick(&shown.second(), Qt::Key_Down); // its second line
    reached.clear();
    QTest::keyClick(&shown.second(), Qt::Key_Down);
    QVERIFY(reached.isEmpty()); // the last of all
    QCOMPARE(shown.focused(), &shown.second());
    for (int i = 0; i < 2; ++i)
      QTest::keyClick(&shown.second(), Qt::Key_Up);
    QCOMPARE(shown.focused(), &shown.first());
    shown.lines.setWorking(tracedWorking(), {3, 0});
    QTest::keyClick(&shown.first(), Qt::Key_Down);
    QTest::keyClick(&shown.first(), Qt::Key_Down);
    QTest::keyClick(&shown.first(), Qt::Key_Down);
    QCOMPARE(shown.focused(), &shown.first()); // an empty block is nowhere to go
  }

  void escape_letsGoOfTheNumberChosenInTheOtherBlock() {
    ShownBlocks shown(tracedWorking());
    QTest::keyClick(&shown.second(), Qt::Key_Right);
    const QString chosen = shown.second().spoken();
    QVERIFY(!chosen.contains('\n'));
    QTest::keyClick(&shown.first(), Qt::Key_Escape);
    QVERIFY(shown.second().spoken() != chosen);
  }

  void blocksThatWereDropped_areHeardNoMore() {
    ShownBlocks shown(tracedWorking());
    WorkingBlock &gone = shown.first();
    QSignalSpy changed(&shown.lines, &StepWorking::traceChanged);
    shown.lines.dropBlocks();
    click(gone, numberIn(gone, 0, "5"));
    QTest::keyClick(&gone, Qt::Key_Down);
    QTest::keyClick(&gone, Qt::Key_Down);
    QVERIFY(changed.isEmpty());
  }

  void blockThatIsDeleted_isForgotten() {
    StepWorking lines(m_typesetter);
    delete lines.addBlock();
    QVERIFY(lines.blocks().empty());
    lines.setWorking(tracedWorking(), {3});
  }

  void firstFieldOfAllBlocks_getsTheFocus() {
    ShownBlocks shown(tracedWorking());
    shown.lines.setWorking(tracedWorking(), {1, 2}, blankIn(tracedWorking(), "a"));
    shown.lines.focusField();
    QVERIFY(shown.second().isAncestorOf(shown.focused()));
    shown.lines.setWorking(tracedWorking(), {1, 2});
    shown.lines.focusField();
    QCOMPARE(shown.focused(), &shown.first()); // there is none
  }

  void highlights_holdForBlocksThatComeLater() {
    StepWorking lines(m_typesetter);
    const auto imageOfNewBlock = [&] {
      const std::unique_ptr<WorkingBlock> block(lines.addBlock());
      block->resize(900, 200);
      lines.setWorking(tracedWorking(), {3});
      return block->grab().toImage();
    };
    const QImage plain = imageOfNewBlock();
    lines.setHighlighted({"u"});
    QVERIFY(imageOfNewBlock() != plain);
  }
};

QTEST_MAIN(StepWorkingTest)
#include "step_working_test.moc"
