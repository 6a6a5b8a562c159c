// The numbers in the worked lines: traced, chosen by the keys, scrubbed and typed.
#include "tests/lessons/called_line.h"
#include "tests/widgets/working/working_block_fixture.h"

#include "lessons/term/plain_text.h"
#include "widgets/numbers/number_field.h"

#include <QScrollBar>
#include <QSignalSpy>

using namespace halfspace;
using test::called;
using namespace halfspace::test;

Q_DECLARE_METATYPE(halfspace::CoordinateSource)
Q_DECLARE_METATYPE(halfspace::Rational)

namespace {

/// u·u = 1·1 + 2·2 = 5, a = 2(u·u) = 2·5 = 10, and b = 3 without any number of u.
Working tracedWorking(int x = 1, const Rational &b = 3) {
  const Term u = given(vectorLetter("u"), ExactVec3(x, 2, 0), "L", 1).marked("u");
  const Term w = given(vectorLetter("w"), ExactVec3(b, 0, 0), "L", 0).marked("w");
  const Term a = name(letter("a"), Rational(2 * (4 + x * x)));
  return {{called("uu", line({withProducts(dot(u, u))})),
           called("a", line({withNumbers(a == 2 * dot(u, u))})),
           called("b", line({withNumbers(name(letter("b"), abs(b)) == norm(w))}))}};
}

/// The first of the line's shown numbers that reads so.
NumberPlace numberIn(const WorkingBlock &panel, std::size_t line, const std::string &text) {
  for (const NumberPlace &place : panel.shownNumbers().inLine(line))
    if (plainText(place.number) == text)
      return place;
  QTest::qFail(("there is no " + text).c_str(), __FILE__, __LINE__);
  return {"", LinePiece::Symbols, 0, 0};
}

/// Where the number stands, in the viewport.
QPoint middleOf(const WorkingBlock &panel, const NumberPlace &number) {
  const auto boxes = panel.shownNumbers().boxesOf(number);
  const QPointF scrolled(panel.horizontalScrollBar()->value(), panel.verticalScrollBar()->value());
  return boxes.empty() ? QPoint(-1, -1) : (boxes.front().center() - scrolled).toPoint();
}

void click(WorkingBlock &panel, const NumberPlace &number) {
  QTest::mouseClick(panel.viewport(), Qt::LeftButton, {}, middleOf(panel, number));
}

/// Moves the pointer with the left button down.
void dragPointer(WorkingBlock &panel, QPoint position) {
  QMouseEvent move(QEvent::MouseMove, position, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(panel.viewport(), &move);
}

using Ids = std::set<std::string>;

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

  void clickedNumberTellsTheLinesAndMarksThatItCameFrom() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy changed(&panel, &WorkingBlock::traceChanged);
    click(panel, numberIn(panel, 1, "10"));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(panel.traced().lines, Ids{"uu"});
    QCOMPARE(panel.traced().marks, Ids{"u"});
    click(panel, numberIn(panel, 2, "3"));
    QCOMPARE(panel.traced().marks, Ids{"w"});
    QCOMPARE(panel.traced().lines, Ids{});
  }

  void traceIsShownOnTheNumberAndOnTheLinesThatItCameFrom() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    const NumberPlace number = numberIn(panel, 1, "10");
    const QPoint atNumber = middleOf(panel, number) + QPoint(0, -2);
    const auto atLine = [&](std::size_t line) {
      return QPoint(450, static_cast<int>(panel.placed().lines[line].box.bottom()) - 3);
    };
    const QImage before = panel.viewport()->grab().toImage();
    click(panel, number);
    const QImage after = panel.viewport()->grab().toImage();
    QVERIFY(after.pixelColor(atLine(0)) != before.pixelColor(atLine(0)));
    QVERIFY(after.pixelColor(atLine(2)) == before.pixelColor(atLine(2)));
    const QRect around(atNumber - QPoint(12, 12), QSize(24, 24));
    QVERIFY(after.copy(around) != before.copy(around));
  }

  void traceEndsWithEscapeAndWithAClickElsewhere() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    click(panel, numberIn(panel, 1, "10"));
    QTest::keyClick(&panel, Qt::Key_Escape);
    QVERIFY(panel.traced() == Provenance());
    click(panel, numberIn(panel, 1, "10"));
    QTest::mouseClick(panel.viewport(), Qt::LeftButton, {},
                      panel.placed().lines[2].box.bottomRight().toPoint() - QPoint(5, 5));
    QVERIFY(panel.traced() == Provenance());
  }

  void traceFollowsItsPlaceAndComesBackWithIt() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    click(panel, numberIn(panel, 1, "10"));
    panel.setWorking(tracedWorking(4));
    QCOMPARE(panel.traced().lines, Ids{"uu"});
    Working without = tracedWorking();
    without.lines.erase(without.lines.begin() + 1);
    panel.setWorking(without);
    QVERIFY(panel.traced() == Provenance());
    panel.setWorking(tracedWorking(3));
    QCOMPARE(panel.traced().lines, Ids{"uu"});
  }

  void numberIsFollowedThroughLinesThatAreNotShown() {
    WorkingBlock panel(m_typesetter);
    panel.setWholeWorking([] { return tracedWorking(); });
    Working part = tracedWorking();
    part.lines.erase(part.lines.begin());
    show(panel, 900, part);
    click(panel, numberIn(panel, 0, "5"));
    QCOMPARE(panel.traced().lines, Ids{"uu"});
    QCOMPARE(panel.traced().marks, Ids{"u"});
  }

  void numbersOfABlankLineCannotBeTouchedNorTraced() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    const NumberPlace result = numberIn(panel, 1, "10");
    const QPoint at = middleOf(panel, result);
    click(panel, result);
    panel.setWorking(tracedWorking(), blankIn(tracedWorking(), "a"));
    QVERIFY(panel.traced() == Provenance());
    QVERIFY(panel.shownNumbers().inLine(1).empty());
    QTest::mouseClick(panel.viewport(), Qt::LeftButton, {}, at);
    QVERIFY(panel.traced() == Provenance());
    panel.setWorkingWithoutNumbers(tracedWorking());
    for (std::size_t i = 0; i < 3; ++i)
      QVERIFY(panel.shownNumbers().inLine(i).empty());
  }

  void blankLineIsLitUpWithoutItsNumbers() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    panel.setWorking(tracedWorking(), blankIn(tracedWorking(), "uu"));
    click(panel, numberIn(panel, 1, "10"));
    QCOMPARE(panel.traced().lines, Ids{"uu"});
    QCOMPARE(panel.placed().lines[0].formulas.size(), std::size_t(2)); // the symbols, and = with the field
    QVERIFY(panel.shownNumbers().inLine(0).empty());
  }

  void clickOnANumberOfALineInHalfDoesNotScroll() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    panel.resize(900, static_cast<int>(panel.placed().lines[1].box.center().y()) + 8);
    click(panel, numberIn(panel, 1, "5"));
    QCOMPARE(panel.traced().lines, Ids{"uu"});
    QCOMPARE(panel.verticalScrollBar()->value(), 0);
  }

  void pointerOverNumbersSaysWhatTheyCanDo() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    movePointer(panel, middleOf(panel, numberIn(panel, 1, "10")));
    QCOMPARE(panel.viewport()->cursor().shape(), Qt::PointingHandCursor);
    movePointer(panel, middleOf(panel, numberIn(panel, 0, "2")));
    QCOMPARE(panel.viewport()->cursor().shape(), Qt::SizeHorCursor);
    movePointer(panel, {5, 5});
    QCOMPARE(panel.viewport()->cursor().shape(), Qt::ArrowCursor);
  }

  void numberInsideAMarkHoversTheMark() {
    WorkingBlock panel(m_typesetter);
    const Term a = name(letter("a"), Rational(7)).standingFor(name(letter("b"), Rational(7)));
    show(panel, 900, {{called("a", line({Chain(a).then(calculated(a).marked("m"))}))}});
    QSignalSpy hovered(&panel, &WorkingBlock::markHovered);
    movePointer(panel, middleOf(panel, numberIn(panel, 0, "7")));
    QCOMPARE(hovered.takeLast().at(0).toString(), QString("m"));
    panel.setInkOf([](const QString &mark) { return mark == "m" ? Qt::red : Qt::black; });
    const QImage shown = panel.viewport()->grab().toImage();
    bool isRed = false;
    for (int x = -6; x <= 6; ++x)
      for (int y = -8; y <= 8; ++y) {
        const QColor color = shown.pixelColor(middleOf(panel, numberIn(panel, 0, "7")) + QPoint(x, y));
        isRed = isRed || (color.red() > 200 && color.green() < 60);
      }
    QVERIFY(isRed);
  }

  void numbersOfABrokenFormulaAreFoundWhereTheyStand() {
    WorkingBlock panel(m_typesetter);
    std::vector<Term> summands;
    for (int i = 0; i < 40; ++i)
      summands.push_back(calculated(name(letter("a", std::to_string(i)), Rational(100 + i))));
    show(panel, 300, {{called("a", line(sum(summands)))}});
    const auto places = panel.shownNumbers().inLine(0);
    QCOMPARE(places.size(), std::size_t(40));
    for (const NumberPlace &place : places) {
      const QRectF box = panel.shownNumbers().boxesOf(place).front();
      QVERIFY(box.right() <= 300);
      QVERIFY(*panel.shownNumbers().at(box.center()) == place);
    }
    const QRectF first = panel.shownNumbers().boxesOf(places.front()).front();
    const QRectF last = panel.shownNumbers().boxesOf(places.back()).front();
    QVERIFY(last.top() > first.bottom());
  }

  void draggedCoordinateIsScrubbedByMovementThoughTheFormulaMovesAway() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy started(&panel, &WorkingBlock::scrubStarted);
    QSignalSpy scrubbed(&panel, &WorkingBlock::scrubbed);
    QSignalSpy ended(&panel, &WorkingBlock::scrubEnded);
    connect(&panel, &WorkingBlock::scrubbed, this,
            [&](int steps) { panel.setWorking(steps == 2 ? Working{} : tracedWorking(1 + steps * 1000)); });
    const QPoint at = middleOf(panel, numberIn(panel, 0, "1"));
    QTest::mousePress(panel.viewport(), Qt::LeftButton, {}, at);
    QCOMPARE(started.count(), 0);
    for (int steps = 1; steps <= 3; ++steps)
      dragPointer(panel, at + QPoint(8 * steps, 60));
    QCOMPARE(started.count(), 1);
    const auto source = started.front().front().value<CoordinateSource>();
    QVERIFY((source == CoordinateSource{"L", 1, 0}));
    QCOMPARE(scrubbed.last().front().toInt(), 3);
    QTest::mouseRelease(panel.viewport(), Qt::LeftButton, {}, at + QPoint(24, 60));
    QCOMPARE(ended.last().front().toBool(), true);
    QVERIFY(panel.traced() == Provenance()); // it was no click
  }

  void escapeTakesAScrubBack() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy ended(&panel, &WorkingBlock::scrubEnded);
    const QPoint at = middleOf(panel, numberIn(panel, 0, "1"));
    QTest::mousePress(panel.viewport(), Qt::LeftButton, {}, at);
    dragPointer(panel, at + QPoint(40, 0));
    QTest::keyClick(&panel, Qt::Key_Escape);
    QCOMPARE(ended.count(), 1);
    QCOMPARE(ended.last().front().toBool(), false);
    QTest::mouseRelease(panel.viewport(), Qt::LeftButton, {}, at + QPoint(40, 0));
    QCOMPARE(ended.count(), 1);
  }

  void scrubThatEndsBeforeTheButtonIsUpIsNoClick() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    const QPoint at = middleOf(panel, numberIn(panel, 0, "1"));
    const auto endedBy = [&](const auto &end) {
      QTest::mousePress(panel.viewport(), Qt::LeftButton, {}, at);
      dragPointer(panel, at + QPoint(40, 0));
      end();
      QTest::mouseRelease(panel.viewport(), Qt::LeftButton, {}, at);
      return panel.traced() == Provenance();
    };
    QVERIFY(endedBy([&] { QTest::keyClick(&panel, Qt::Key_Escape); }));
    QVERIFY(endedBy([&] { QCOMPARE(panel.enterTyped(), QString()); }));
  }

  void clickedCoordinateIsTracedToItsMark() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    click(panel, numberIn(panel, 0, "2"));
    QCOMPARE(panel.traced().marks, Ids{"u"});
    QVERIFY((panel.traced().coordinates == std::vector<CoordinateSource>{{"L", 1, 1}}));
  }

  void calculatedNumberIsNotScrubbed() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy started(&panel, &WorkingBlock::scrubStarted);
    const QPoint at = middleOf(panel, numberIn(panel, 1, "10"));
    QTest::mousePress(panel.viewport(), Qt::LeftButton, {}, at);
    dragPointer(panel, at + QPoint(40, 0));
    QTest::mouseRelease(panel.viewport(), Qt::LeftButton, {}, at + QPoint(40, 0));
    QCOMPARE(started.count(), 0);
  }

  void doubleClickedCoordinateIsTypedInItsPlace() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy typed(&panel, &WorkingBlock::coordinateTyped);
    const QPoint at = middleOf(panel, numberIn(panel, 0, "2"));
    QTest::mouseDClick(panel.viewport(), Qt::LeftButton, {}, at);
    auto *field = panel.findChild<NumberField *>();
    QVERIFY(field);
    QVERIFY(field->geometry().contains(at));
    QCOMPARE(field->text(), QString("2"));
    QTest::keyClicks(field, "1 1/2");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(typed.count(), 1);
    QVERIFY((typed.front()[0].value<CoordinateSource>() == CoordinateSource{"L", 1, 1}));
    QVERIFY(typed.front()[1].value<Rational>() == Rational(3, 2));
    QTRY_VERIFY(!panel.findChild<NumberField *>());
    QVERIFY(panel.hasFocus());
  }

  void escapeDropsWhatIsTyped() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy typed(&panel, &WorkingBlock::coordinateTyped);
    QTest::mouseDClick(panel.viewport(), Qt::LeftButton, {}, middleOf(panel, numberIn(panel, 0, "2")));
    auto *field = panel.findChild<NumberField *>();
    QTest::keyClicks(field, "7");
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_VERIFY(!panel.findChild<NumberField *>());
    QCOMPARE(typed.count(), 0);
  }

  void fieldThatLosesTheFocusTakesWhatIsTyped() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy typed(&panel, &WorkingBlock::coordinateTyped);
    QTest::mouseDClick(panel.viewport(), Qt::LeftButton, {}, middleOf(panel, numberIn(panel, 0, "2")));
    QApplication::setActiveWindow(&panel);
    QTest::keyClicks(panel.findChild<NumberField *>(), "7");
    panel.setFocus();
    QCOMPARE(typed.count(), 1);
    QTRY_VERIFY(!panel.findChild<NumberField *>());
  }

  void refusedTextStaysWithASentenceBelowItsLine() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QSignalSpy typed(&panel, &WorkingBlock::coordinateTyped);
    QTest::mouseDClick(panel.viewport(), Qt::LeftButton, {}, middleOf(panel, numberIn(panel, 0, "2")));
    auto *field = panel.findChild<NumberField *>();
    QTest::keyClicks(field, "seven");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(typed.count(), 0);
    const auto remark = panel.placed().lines[0].remark;
    QVERIFY(!remark.empty());
    QVERIFY(remark.front().text.contains("seven"));
    QVERIFY(!panel.enterTyped().isEmpty());
    panel.dropTyped();
    QVERIFY(panel.placed().lines[0].remark.empty());
    QCOMPARE(typed.count(), 0);
  }

  void fieldGoesWithItsNumber() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QTest::mouseDClick(panel.viewport(), Qt::LeftButton, {}, middleOf(panel, numberIn(panel, 0, "1")));
    panel.setWorking(tracedWorking(9));
    QCOMPARE(panel.findChild<NumberField *>()->text(), QString("9"));
    panel.setWorking({});
    QTRY_VERIFY(!panel.findChild<NumberField *>());
  }

  void arrowKeysChooseNumbersAndEnterTracesOrTypesThem() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    panel.setFocus();
    QTest::keyClick(&panel, Qt::Key_Down);
    QTest::keyClick(&panel, Qt::Key_Down);
    QTest::keyClick(&panel, Qt::Key_Right);
    QCOMPARE(panel.accessibleDescription(), QString::fromUtf8("5, from u dot u"));
    QTest::keyClick(&panel, Qt::Key_Return);
    QCOMPARE(panel.traced().lines, Ids{"uu"});
    QTest::keyClick(&panel, Qt::Key_Up);
    QVERIFY(panel.accessibleDescription().contains('\n')); // all lines again
    QTest::keyClick(&panel, Qt::Key_Right);
    QTest::keyClick(&panel, Qt::Key_Right);
    QTest::keyClick(&panel, Qt::Key_Left);
    QCOMPARE(panel.accessibleDescription(), QString::fromUtf8("1, x of u"));
    QTest::keyClick(&panel, Qt::Key_Return);
    QVERIFY(panel.findChild<NumberField *>());
  }

  void chosenNumberHasARing() {
    WorkingBlock panel(m_typesetter);
    show(panel, 900, tracedWorking());
    QApplication::setActiveWindow(&panel);
    panel.setFocus();
    QTest::keyClick(&panel, Qt::Key_Down);
    const QImage before = panel.viewport()->grab().toImage();
    QTest::keyClick(&panel, Qt::Key_Right);
    const QRectF box = panel.shownNumbers().boxesOf(panel.shownNumbers().inLine(0).front()).front();
    const QRect around = box.adjusted(-4, -4, 4, 4).toRect();
    QVERIFY(panel.viewport()->grab().toImage().copy(around) != before.copy(around));
  }
};

QTEST_MAIN(WorkingNumbersTest)
#include "working_numbers_test.moc"
