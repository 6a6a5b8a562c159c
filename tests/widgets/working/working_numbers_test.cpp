// The numbers in the worked lines: traced, chosen by the keys, scrubbed and typed.
#include "tests/widgets/working/working_block_fixture.h"

#include "widgets/numbers/number_field.h"

#include <QSignalSpy>

using namespace halfspace;
using namespace halfspace::test;

Q_DECLARE_METATYPE(halfspace::CoordinateSource)
Q_DECLARE_METATYPE(halfspace::Rational)

namespace {

/// Moves the pointer with the left button down.
void drag(WorkingBlock &block, QPoint to) { movePointer(block, to, Qt::LeftButton); }

/// The numbers whose traces a block has asked for.
struct TraceRequests {
  explicit TraceRequests(WorkingBlock &block) {
    QObject::connect(&block, &WorkingBlock::traceRequested,
                     [this](const NumberPlace &number) { numbers.push_back(number); });
  }
  std::vector<NumberPlace> numbers;
};

} // namespace

class WorkingNumbersTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void initTestCase() {
    qRegisterMetaType<CoordinateSource>("halfspace::CoordinateSource");
    qRegisterMetaType<Rational>("halfspace::Rational");
  }

  void clickOnANumberOfALineInHalf_asksForItsTraceAndForNoScrolling() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    const TraceRequests traced(block);
    QSignalSpy reached(&block, &WorkingBlock::reached);
    const NumberPlace number = numberIn(block, 1, "5");
    click(block, number);
    QVERIFY(traced.numbers == std::vector{number});
    QVERIFY(reached.isEmpty()); // the number stays under the pointer
  }

  void clickBesideTheNumbers_dropsTheTrace() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy dropped(&block, &WorkingBlock::traceDropped);
    QTest::mouseClick(&block, Qt::LeftButton, {}, {5, 5});
    QCOMPARE(dropped.count(), 1);
  }

  void pointerOverNumbersSaysWhatTheyCanDo() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    movePointer(block, middleOf(block, numberIn(block, 1, "10")));
    QCOMPARE(block.cursor().shape(), Qt::PointingHandCursor);
    movePointer(block, middleOf(block, numberIn(block, 0, "2")));
    QCOMPARE(block.cursor().shape(), Qt::SizeHorCursor);
    movePointer(block, {5, 5});
    QCOMPARE(block.cursor().shape(), Qt::ArrowCursor);
  }

  void numberInsideAMarkHoversTheMark() {
    WorkingBlock block(m_typesetter);
    const Term a = name(letter("a"), Rational(7)).standingFor(name(letter("b"), Rational(7)));
    show(block, 900, {{called("a", line({Chain(a).then(calculated(a).marked("m"))}))}});
    QSignalSpy hovered(&block, &WorkingBlock::markHovered);
    movePointer(block, middleOf(block, numberIn(block, 0, "7")));
    QCOMPARE(hovered.takeLast().at(0).toString(), QString("m"));
    block.setLook({.inkOf = [](const QString &mark) { return mark == "m" ? Qt::red : Qt::black; }});
    const QImage shown = block.grab().toImage();
    bool isRed = false;
    for (int x = -6; x <= 6; ++x)
      for (int y = -8; y <= 8; ++y) {
        const QColor color = shown.pixelColor(middleOf(block, numberIn(block, 0, "7")) + QPoint(x, y));
        isRed = isRed || (color.red() > 200 && color.green() < 60);
      }
    QVERIFY(isRed);
  }

  void numbersOfABrokenFormulaAreFoundWhereTheyStand() {
    WorkingBlock block(m_typesetter);
    std::vector<Term> summands;
    for (int i = 0; i < 40; ++i)
      summands.push_back(calculated(name(letter("a", std::to_string(i)), Rational(100 + i))));
    show(block, 300, {{called("a", line(sum(summands)))}});
    const auto places = block.shownNumbers().inLine(0);
    QCOMPARE(places.size(), std::size_t(40));
    for (const NumberPlace &place : places) {
      const QRectF box = block.shownNumbers().boxesOf(place).front();
      QVERIFY(box.right() <= 300);
      QVERIFY(*block.shownNumbers().at(box.center()) == place);
    }
    const QRectF first = block.shownNumbers().boxesOf(places.front()).front();
    const QRectF last = block.shownNumbers().boxesOf(places.back()).front();
    QVERIFY(last.top() > first.bottom());
  }

  void draggedCoordinateIsScrubbedByMovementThoughTheFormulaMovesAway() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy started(&block.coordinates(), &CoordinateInput::scrubStarted);
    QSignalSpy scrubbed(&block.coordinates(), &CoordinateInput::scrubbed);
    QSignalSpy ended(&block.coordinates(), &CoordinateInput::scrubEnded);
    const TraceRequests traced(block);
    connect(&block.coordinates(), &CoordinateInput::scrubbed, this,
            [&](int steps) { block.setWorking(steps == 2 ? Working{} : tracedWorking(1 + steps * 1000)); });
    const QPoint at = middleOf(block, numberIn(block, 0, "1"));
    QTest::mousePress(&block, Qt::LeftButton, {}, at);
    QCOMPARE(started.count(), 0);
    for (int steps = 1; steps <= 3; ++steps)
      drag(block, at + QPoint(8 * steps, 60));
    QCOMPARE(started.count(), 1);
    const auto source = started.front().front().value<CoordinateSource>();
    QVERIFY((source == CoordinateSource{"L", 1, 0}));
    QCOMPARE(scrubbed.last().front().toInt(), 3);
    QTest::mouseRelease(&block, Qt::LeftButton, {}, at + QPoint(24, 60));
    QCOMPARE(ended.last().front().toBool(), true);
    QVERIFY(traced.numbers.empty()); // it was no click
  }

  void escapeTakesAScrubBack() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy ended(&block.coordinates(), &CoordinateInput::scrubEnded);
    const QPoint at = middleOf(block, numberIn(block, 0, "1"));
    QTest::mousePress(&block, Qt::LeftButton, {}, at);
    drag(block, at + QPoint(40, 0));
    QTest::keyClick(&block, Qt::Key_Escape);
    QCOMPARE(ended.count(), 1);
    QCOMPARE(ended.last().front().toBool(), false);
    QTest::mouseRelease(&block, Qt::LeftButton, {}, at + QPoint(40, 0));
    QCOMPARE(ended.count(), 1);
  }

  void scrubThatEndsBeforeTheButtonIsUpIsNoClick() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    const QPoint at = middleOf(block, numberIn(block, 0, "1"));
    const TraceRequests traced(block);
    const auto endedBy = [&](const auto &end) {
      QTest::mousePress(&block, Qt::LeftButton, {}, at);
      drag(block, at + QPoint(40, 0));
      end();
      QTest::mouseRelease(&block, Qt::LeftButton, {}, at);
      return traced.numbers.empty();
    };
    QVERIFY(endedBy([&] { QTest::keyClick(&block, Qt::Key_Escape); }));
    QVERIFY(endedBy([&] { QCOMPARE(block.coordinates().enter(), QString()); }));
  }

  void calculatedNumberIsNotScrubbed() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy started(&block.coordinates(), &CoordinateInput::scrubStarted);
    const QPoint at = middleOf(block, numberIn(block, 1, "10"));
    QTest::mousePress(&block, Qt::LeftButton, {}, at);
    drag(block, at + QPoint(40, 0));
    QTest::mouseRelease(&block, Qt::LeftButton, {}, at + QPoint(40, 0));
    QCOMPARE(started.count(), 0);
  }

  void doubleClickedCoordinateIsTypedInItsPlace() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy typed(&block.coordinates(), &CoordinateInput::coordinateTyped);
    const QPoint at = middleOf(block, numberIn(block, 0, "2"));
    QTest::mouseDClick(&block, Qt::LeftButton, {}, at);
    auto *field = block.findChild<NumberField *>();
    QVERIFY(field);
    QVERIFY(field->geometry().contains(at));
    QCOMPARE(field->text(), QString("2"));
    QTest::keyClicks(field, "1 1/2");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(typed.count(), 1);
    QVERIFY((typed.front()[0].value<CoordinateSource>() == CoordinateSource{"L", 1, 1}));
    QVERIFY(typed.front()[1].value<Rational>() == Rational(3, 2));
    QTRY_VERIFY(!block.findChild<NumberField *>());
    QVERIFY(block.hasFocus());
  }

  void escapeDropsWhatIsTyped() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy typed(&block.coordinates(), &CoordinateInput::coordinateTyped);
    QTest::mouseDClick(&block, Qt::LeftButton, {}, middleOf(block, numberIn(block, 0, "2")));
    auto *field = block.findChild<NumberField *>();
    QTest::keyClicks(field, "7");
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_VERIFY(!block.findChild<NumberField *>());
    QCOMPARE(typed.count(), 0);
  }

  void fieldThatLosesTheFocusTakesWhatIsTyped() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy typed(&block.coordinates(), &CoordinateInput::coordinateTyped);
    QTest::mouseDClick(&block, Qt::LeftButton, {}, middleOf(block, numberIn(block, 0, "2")));
    QApplication::setActiveWindow(&block);
    QTest::keyClicks(block.findChild<NumberField *>(), "7");
    block.setFocus();
    QCOMPARE(typed.count(), 1);
    QTRY_VERIFY(!block.findChild<NumberField *>());
  }

  void refusedTextStaysWithASentenceBelowItsLine() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QSignalSpy typed(&block.coordinates(), &CoordinateInput::coordinateTyped);
    QTest::mouseDClick(&block, Qt::LeftButton, {}, middleOf(block, numberIn(block, 0, "2")));
    auto *field = block.findChild<NumberField *>();
    QTest::keyClicks(field, "seven");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(typed.count(), 0);
    const auto remark = block.placed().lines[0].remark;
    QVERIFY(!remark.empty());
    QVERIFY(remark.front().text.contains("seven"));
    QVERIFY(!block.coordinates().enter().isEmpty());
    block.coordinates().closeField();
    QVERIFY(block.placed().lines[0].remark.empty());
    QCOMPARE(typed.count(), 0);
  }

  void fieldGoesWithItsNumber() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QTest::mouseDClick(&block, Qt::LeftButton, {}, middleOf(block, numberIn(block, 0, "1")));
    block.setWorking(tracedWorking(9));
    QCOMPARE(block.findChild<NumberField *>()->text(), QString("9"));
    block.setWorking({});
    QTRY_VERIFY(!block.findChild<NumberField *>());
  }

  void arrowKeysChooseNumbersAndEnterTracesOrTypesThem() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    const TraceRequests traced(block);
    block.setFocus();
    QTest::keyClick(&block, Qt::Key_Down);
    QTest::keyClick(&block, Qt::Key_Down);
    QTest::keyClick(&block, Qt::Key_Right);
    QCOMPARE(block.spoken(), QString::fromUtf8("5, from u dot u"));
    QTest::keyClick(&block, Qt::Key_Return);
    QVERIFY(traced.numbers == std::vector{numberIn(block, 1, "5")});
    QTest::keyClick(&block, Qt::Key_Up);
    QVERIFY(block.spoken().contains('\n')); // all lines again
    QTest::keyClick(&block, Qt::Key_Right);
    QTest::keyClick(&block, Qt::Key_Right);
    QTest::keyClick(&block, Qt::Key_Left);
    QCOMPARE(block.spoken(), QString::fromUtf8("1, x of u"));
    QTest::keyClick(&block, Qt::Key_Return);
    QVERIFY(block.findChild<NumberField *>());
  }

  void chosenNumberHasARing() {
    WorkingBlock block(m_typesetter);
    show(block, 900, tracedWorking());
    QApplication::setActiveWindow(&block);
    block.setFocus();
    QTest::keyClick(&block, Qt::Key_Down);
    const QImage before = block.grab().toImage();
    QTest::keyClick(&block, Qt::Key_Right);
    const QRectF box = block.shownNumbers().boxesOf(block.shownNumbers().inLine(0).front()).front();
    const QRect around = box.adjusted(-4, -4, 4, 4).toRect();
    QVERIFY(block.grab().toImage().copy(around) != before.copy(around));
  }
};

QTEST_MAIN(WorkingNumbersTest)
#include "working_numbers_test.moc"
