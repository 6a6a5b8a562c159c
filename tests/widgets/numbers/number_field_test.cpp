// A field for one exact number, typed in with real keys and scrubbed with a real mouse.
#include "widgets/numbers/number_field.h"

#include "lessons/reading/typed_number.h"
#include "tests/lessons/spoken_to_in.h"
#include "tests/widgets/pointer.h"

#include <QSignalSpy>
#include <QVBoxLayout>

using namespace halfspace;

Q_DECLARE_METATYPE(halfspace::Rational)

namespace {

QString textOf(const Rational &value) { return QString::fromStdString(toText(value)); }

/// A shown field of the value 3/2, beside another widget that can have the focus.
struct ShownField {
  explicit ShownField(int width = 120) {
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(&other);
    layout->addWidget(&field);
    field.setFixedWidth(width);
    field.setValue(Rational(3, 2));
    window.show();
    ready = QTest::qWaitForWindowActive(&window);
    other.setFocus();
  }

  /// As a user types, without Return.
  void type(const QString &text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Delete);
    QTest::keyClicks(&field, text);
  }
  QString lastRefusal() const { return refused.isEmpty() ? QString() : refused.last().at(0).toString(); }

  QWidget window;
  QLineEdit other;
  NumberField field;
  bool ready = false;
  QSignalSpy typed{&field, &NumberField::valueTyped};
  QSignalSpy refused{&field, &NumberField::refused};
};

} // namespace

class NumberFieldTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qRegisterMetaType<Rational>("halfspace::Rational"); }

  void exactText_ofANumber_isADecimalWhereItEndsSoon_data() {
    QTest::addColumn<QString>("exact");
    QTest::addColumn<QString>("englishText");
    QTest::addColumn<QString>("germanText");
    const auto row = [](const char *exact, const char *englishText, const char *germanText) {
      QTest::newRow(exact) << exact << englishText << germanText;
    };
    row("12", "12", "12");
    row("-1/4", "-0.25", "-0,25");
    row("1/16", "0.0625", "0,0625");
    row("25/2", "12.5", "12,5");
    row("1/32", "1/32", "1/32");
    row("-10/3", "-10/3", "-10/3");
  }

  void exactText_ofANumber_isADecimalWhereItEndsSoon() {
    QFETCH(QString, exact);
    QFETCH(QString, englishText);
    QFETCH(QString, germanText);
    const Rational value = *parseRational(exact.toStdString());
    QCOMPARE(typedText(value), englishText);
    QVERIFY(parseTyped(englishText) == value);
    const test::SpokenToIn german(test::withDecimalComma());
    QCOMPARE(typedText(value), germanText);
    QVERIFY(parseTyped(germanText) == value);
  }

  void commas_inALanguageWithPoints_areNoDecimals() {
    QVERIFY(!parseTyped("1,5"));
    const test::SpokenToIn german(test::withDecimalComma());
    QVERIFY(parseTyped("1,5") == Rational(3, 2));
    QVERIFY(parseTyped("1.5") == Rational(3, 2));
  }

  void text_enteredByReturn_isTheValueOnce() {
    ShownField shown;
    QVERIFY(shown.ready);
    shown.type(" 7/4 ");
    QCOMPARE(shown.typed.count(), 0);
    QTest::keyClick(&shown.field, Qt::Key_Return);
    QVERIFY(shown.field.value() == Rational(7, 4));
    QCOMPARE(shown.field.text(), QString("1.75"));
    shown.other.setFocus(); // nothing new to enter
    QCOMPARE(shown.typed.count(), 1);
    QVERIFY(shown.typed.first().at(0).value<Rational>() == Rational(7, 4));
  }

  void text_leftForAnotherWidget_isEntered() {
    ShownField shown;
    QVERIFY(shown.ready);
    shown.type("-8");
    shown.other.setFocus();
    QCOMPARE(shown.typed.count(), 1);
    QVERIFY(shown.field.value() == -8);
  }

  void text_thatIsRefused_staysWithTheReason_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    const QString tooLarge = textOf(Rational(coordinateLimit + 1));
    QTest::newRow("word") << "seven"
                          << "seven";
    QTest::newRow("nothing") << ""
                             << "";
    QTest::newRow("zero below") << "1/0"
                                << "";
    QTest::newRow("too large") << tooLarge << "too large";
  }

  void text_thatIsRefused_staysWithTheReason() {
    QFETCH(QString, text);
    QFETCH(QString, reason);
    ShownField shown;
    QVERIFY(shown.ready);
    shown.type(text);
    const QString why = shown.field.enter();
    QVERIFY2(!why.isEmpty() && why.contains(reason), qPrintable(why));
    QCOMPARE(shown.lastRefusal(), why);
    QCOMPARE(shown.field.text(), text);
    QVERIFY(shown.field.property("wrong").toBool());
    QVERIFY(shown.field.value() == Rational(3, 2));
    QCOMPARE(shown.typed.count(), 0);
  }

  void refusedText_mended_takesTheReasonBack() {
    ShownField shown;
    QVERIFY(shown.ready);
    shown.type("seven");
    QTest::keyClick(&shown.field, Qt::Key_Return);
    shown.type("7");
    QTest::keyClick(&shown.field, Qt::Key_Return);
    QCOMPARE(shown.lastRefusal(), QString());
    QVERIFY(!shown.field.property("wrong").toBool());
    QVERIFY(shown.field.value() == 7);
  }

  void refusedText_clicked_isMendedThere() {
    ShownField shown;
    QVERIFY(shown.ready);
    shown.type("x2");
    shown.other.setFocus();
    QVERIFY(!shown.lastRefusal().isEmpty());
    QTest::mouseClick(&shown.field, Qt::LeftButton);
    QVERIFY(shown.field.hasFocus());
    QCOMPARE(shown.field.text(), QString("x2"));
  }

  void doubleClick_selectsTheWholeFraction() {
    ShownField shown;
    QVERIFY(shown.ready);
    shown.field.setValue(Rational(1, 17), NumberLook::Fraction);
    QTest::mouseClick(&shown.field, Qt::LeftButton);
    QTest::mouseDClick(&shown.field, Qt::LeftButton);
    QCOMPARE(shown.field.selectedText(), QString("1/17"));
  }

  void escape_inAHalfTypedField_showsTheValueAgain() {
    ShownField shown;
    QVERIFY(shown.ready);
    QSignalSpy dropped(&shown.field, &NumberField::dropped);
    shown.type("99");
    QTest::keyClick(&shown.field, Qt::Key_Escape);
    QCOMPARE(shown.field.text(), QString("1.5"));
    QCOMPARE(dropped.count(), 1);
    shown.other.setFocus();
    QCOMPARE(shown.typed.count(), 0);
  }

  void newValue_whileSomethingIsTyped_leavesTheTextOnlyWhereItIsTheSame() {
    ShownField shown;
    QVERIFY(shown.ready);
    shown.type("4");
    shown.field.setValue(Rational(3, 2)); // another number of the scene has changed
    QCOMPARE(shown.field.text(), QString("4"));
    shown.field.setValue(9); // this one has
    QCOMPARE(shown.field.text(), QString("9"));
  }

  void newValue_whileARefusedTextWaits_leavesItToBeMended() {
    ShownField shown;
    QVERIFY(shown.ready);
    shown.type("seven");
    shown.other.setFocus();
    shown.field.setValue(Rational(3, 2));
    QCOMPARE(shown.field.text(), QString("seven"));
    QVERIFY(shown.field.property("wrong").toBool());
  }

  void arrowKeys_stepByOne_andWithCtrlByTen_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<int>("steps");
    QTest::newRow("up") << int(Qt::Key_Up) << int(Qt::NoModifier) << 1;
    QTest::newRow("down") << int(Qt::Key_Down) << int(Qt::NoModifier) << -1;
    QTest::newRow("ctrl up") << int(Qt::Key_Up) << int(Qt::ControlModifier) << 10;
    QTest::newRow("ctrl down") << int(Qt::Key_Down) << int(Qt::ControlModifier) << -10;
  }

  void arrowKeys_stepByOne_andWithCtrlByTen() {
    QFETCH(int, key);
    QFETCH(int, modifiers);
    QFETCH(int, steps);
    ShownField shown;
    QVERIFY(shown.ready);
    QSignalSpy stepped(&shown.field, &NumberField::stepped);
    shown.field.setFocus();
    QTest::keyClick(&shown.field, static_cast<Qt::Key>(key), Qt::KeyboardModifiers(modifiers));
    QCOMPARE(stepped.count(), 1);
    QCOMPARE(stepped.first().at(0).toInt(), steps);
  }

  void press_thatIsAClick_selectsTheNumberForTyping() {
    ShownField shown;
    QVERIFY(shown.ready);
    QTest::mouseClick(&shown.field, Qt::LeftButton, {}, {10, 8});
    QVERIFY(shown.field.hasFocus());
    QCOMPARE(shown.field.selectedText(), QString("1.5"));
    QTest::mouseClick(&shown.field, Qt::LeftButton, {}, {10, 8}); // again: to place the cursor
    QVERIFY(!shown.field.hasSelectedText());
  }

  void drag_sideways_scrubsWithoutTakingTheFocus() {
    ShownField shown;
    QVERIFY(shown.ready);
    QSignalSpy scrubbed(&shown.field.scrub(), &Scrub::moved);
    QSignalSpy ended(&shown.field.scrub(), &Scrub::ended);
    test::dragPointer(shown.field, {20, 8}, {60, 8});
    QCOMPARE(scrubbed.last().at(0).toInt(), 5);
    QCOMPARE(ended.count(), 1);
    QVERIFY(ended.first().at(0).toBool());
    QVERIFY(shown.other.hasFocus());
  }

  void escape_duringAScrub_endsItUnkept_andKeepsTheField() {
    ShownField shown;
    QVERIFY(shown.ready);
    QSignalSpy ended(&shown.field.scrub(), &Scrub::ended);
    QSignalSpy dropped(&shown.field, &NumberField::dropped);
    QTest::mousePress(&shown.field, Qt::LeftButton, {}, {20, 8});
    test::movePointer(shown.field, {60, 8}, Qt::LeftButton);
    QVERIFY(shown.field.scrub().isScrubbing());
    QTest::keyClick(&shown.field, Qt::Key_Escape);
    QVERIFY(!shown.field.scrub().isScrubbing());
    QVERIFY(!ended.first().at(0).toBool());
    QCOMPARE(dropped.count(), 0);
  }

  void drag_inAHalfTypedText_choosesLettersInstead() {
    ShownField shown;
    QVERIFY(shown.ready);
    QSignalSpy started(&shown.field.scrub(), &Scrub::started);
    shown.type("12345");
    test::dragPointer(shown.field, {shown.field.width() - 4, 8}, {4, 8});
    QCOMPARE(started.count(), 0);
    QVERIFY(shown.field.hasSelectedText());
  }

  void longNumber_inANarrowField_isShownRoundedUntilItIsEdited() {
    ShownField shown(70);
    QVERIFY(shown.ready);
    shown.field.setValue(Rational(1234567, 9001));
    const QString rounded = shown.field.shownText();
    QVERIFY2(rounded.startsWith(QString::fromUtf8("≈ 137")), qPrintable(rounded));
    QVERIFY(shown.field.fontMetrics().horizontalAdvance(rounded) < shown.field.width());
    shown.field.setFocus();
    QCOMPARE(shown.field.shownText(), QString("1234567/9001"));
  }

  void longNumber_withFewDigits_isShownExactlyAsAPowerOfTen() {
    ShownField shown(70);
    QVERIFY(shown.ready);
    shown.field.setValue(-5 * powerOfTen(17));
    QCOMPARE(shown.field.shownText(), QString::fromUtf8("-5·10¹⁷"));
    shown.field.setValue(powerOfTen(-17));
    QCOMPARE(shown.field.shownText(), QString::fromUtf8("1·10⁻¹⁷"));
  }

  void longRefusedText_inANarrowField_isCutAndNotRounded() {
    ShownField shown(70);
    QVERIFY(shown.ready);
    shown.type("seven hundred and seventy");
    shown.other.setFocus();
    const QString cut = shown.field.shownText();
    QVERIFY2(cut.startsWith("sev") && cut.endsWith(QString::fromUtf8("…")), qPrintable(cut));
  }
};

QTEST_MAIN(NumberFieldTest)
#include "number_field_test.moc"
