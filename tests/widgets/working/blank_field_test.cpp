// The field in place of what a worked line leaves out, with real keys and clicks.
#include "widgets/working/blank_field.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

using namespace halfspace;

class BlankFieldTest : public QObject {
  Q_OBJECT

private:
  static QLineEdit &edit(const BlankField &field) { return *field.findChild<QLineEdit *>(); }
  static QToolButton &showButton(const BlankField &field) { return *field.findChild<QToolButton *>(); }
  static bool isMarkedWrong(const BlankField &field) { return edit(field).property("wrong").toBool(); }

private slots:
  void enterAnswersWithTheTextAsItWasTyped_data() {
    QTest::addColumn<QString>("typed");
    for (const char *typed : {"10", "-10/3", " 2*sqrt(43)/3 ", "(1, 2, 3)", "x + 2y = 3", "nonsense"})
      QTest::newRow(typed) << typed;
  }
  void enterAnswersWithTheTextAsItWasTyped() {
    QFETCH(QString, typed);
    BlankField field(12);
    QSignalSpy answered(&field, &BlankField::answered);
    QTest::keyClicks(&edit(field), typed);
    QVERIFY(answered.isEmpty());
    QTest::keyClick(&edit(field), Qt::Key_Return);
    QCOMPARE(answered.count(), 1);
    QCOMPARE(answered.first().at(0).toString(), typed);
    QCOMPARE(edit(field).selectedText(), typed); // to be typed over
  }

  void enterWithoutAText_isNoAnswer() {
    BlankField field(12);
    QSignalSpy answered(&field, &BlankField::answered);
    for (const char *typed : {"", "  "}) {
      QTest::keyClicks(&edit(field), typed);
      QTest::keyClick(&edit(field), Qt::Key_Return);
    }
    QVERIFY(answered.isEmpty());
  }

  void textThatIsLeft_isNoAnswer() {
    BlankField field(12);
    field.show();
    QSignalSpy answered(&field, &BlankField::answered);
    edit(field).setFocus();
    QTest::keyClicks(&edit(field), "10");
    showButton(field).setFocus();
    QVERIFY(answered.isEmpty());
    QCOMPARE(edit(field).text(), QString("10"));
  }

  void keysThatMoveByWords_areShortcutsOfTheWindow() {
    BlankField field(12);
    const auto isTaken = [&](Qt::Key key, Qt::KeyboardModifiers modifiers) {
      QKeyEvent asked(QEvent::ShortcutOverride, key, modifiers);
      asked.ignore();
      QApplication::sendEvent(&edit(field), &asked);
      return asked.isAccepted();
    };
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right}) {
      edit(field).clear();
      QVERIFY(!isTaken(key, Qt::ControlModifier));
      QVERIFY(isTaken(key, Qt::NoModifier));
      edit(field).setText("10");
      QVERIFY(!isTaken(key, Qt::ControlModifier));
    }
  }

  void showButton_asksForTheLineByClickAndByKey() {
    BlankField field(12);
    field.show();
    QSignalSpy asked(&field, &BlankField::showRequested);
    QSignalSpy answered(&field, &BlankField::answered);
    QTest::keyClicks(&edit(field), "10");
    QTest::mouseClick(&showButton(field), Qt::LeftButton);
    QCOMPARE(asked.count(), 1);
    QTest::keyClick(&showButton(field), Qt::Key_Space);
    QCOMPARE(asked.count(), 2);
    QVERIFY(answered.isEmpty());
  }

  void remark_marksTheAnswerUntilItIsMended() {
    BlankField field(12);
    QTest::keyClicks(&edit(field), "1");
    field.setRemark("Not right.");
    QVERIFY(isMarkedWrong(field));
    QCOMPARE(edit(field).accessibleDescription(), QString("Not right."));
    QTest::keyClicks(&edit(field), "0");
    QVERIFY(!isMarkedWrong(field));
    field.setRemark("Not right."); // with every frame of a drag: nothing new is said
    QVERIFY(!isMarkedWrong(field));
    field.setRemark("30 is f(Q).");
    QVERIFY(isMarkedWrong(field));
    field.setRemark({});
    QVERIFY(!isMarkedWrong(field));
    QVERIFY(edit(field).accessibleDescription().isEmpty());
  }

  void questionIsSaidOfTheFieldAndOfTheButton() {
    BlankField field(12);
    for (const char *question : {"t = ?", "h = ?"}) {
      field.setQuestion(question);
      QVERIFY(edit(field).accessibleName().contains(question));
      QVERIFY(showButton(field).accessibleName().contains(question));
      QVERIFY(edit(field).accessibleName() != showButton(field).accessibleName());
    }
  }

  void fieldTakesTheFocusWhereItIsTyped() {
    QWidget window;
    BlankField field(12, &window);
    window.show();
    field.setFocus();
    QCOMPARE(window.focusWidget(), &edit(field));
  }

  void escape_handsTheKeysToWhatTheFieldStandsIn() {
    QWidget window;
    window.setFocusPolicy(Qt::StrongFocus);
    BlankField field(12, &window);
    window.show();
    field.setFocus();
    QTest::keyClicks(&edit(field), "10");
    QTest::keyClick(&edit(field), Qt::Key_Escape);
    QCOMPARE(window.focusWidget(), &window);
    QCOMPARE(edit(field).text(), QString("10"));
  }

  void showButton_standsBesideWhereItIsTyped() {
    BlankField field(12);
    field.resize(field.sizeHint());
    field.show();
    QVERIFY(showButton(field).geometry().left() > edit(field).geometry().right());
    QVERIFY(field.rect().contains(showButton(field).geometry()));
  }

  void showButton_inLessRoomThanTheFieldAsksFor_hasAllOfItsWord() {
    BlankField field(26);
    QFont large = field.font();
    large.setPointSizeF(1.92 * large.pointSizeF());
    field.setFont(large);
    field.resize(field.sizeHint().width() / 2, field.sizeHint().height());
    field.show();
    QVERIFY(field.rect().contains(showButton(field).geometry()));
    QCOMPARE(showButton(field).width(), showButton(field).sizeHint().width());
    QVERIFY(edit(field).width() > edit(field).fontMetrics().averageCharWidth());
  }

  void fieldIsAsWideAsItsLetters() {
    const int few = BlankField(7).sizeHint().width();
    const BlankField many(26);
    QCOMPARE(many.sizeHint().width() - few, 19 * many.fontMetrics().averageCharWidth());
  }
};

QTEST_MAIN(BlankFieldTest)
#include "blank_field_test.moc"
