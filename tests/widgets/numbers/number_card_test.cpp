// The card of the selected object: which numbers it shows, and what typing there does.
#include "widgets/numbers/number_card.h"

#include "tests/lessons/objects.h"
#include "tests/lessons/scenes.h"
#include "tests/widgets/pointer.h"
#include "widgets/numbers/number_field.h"

#include <QLabel>

using namespace halfspace;
using namespace halfspace::test;

namespace {

LessonLibrary libraryOf(Scene scene) {
  Lesson lesson;
  lesson.id = "x";
  lesson.scene = std::move(scene);
  return {{lesson}, {}};
}

/// A shown card that follows a session.
struct ShownCard {
  explicit ShownCard(Scene scene = distanceScene())
      : model(libraryOf(std::move(scene))), card(model, typesetter) {
    card.resize(700, 90);
    card.show();
    ready = QTest::qWaitForWindowActive(&card);
  }

  /// The fields that are shown, by what they are called.
  QStringList fields() const {
    QStringList names;
    for (const NumberField *field : card.findChildren<NumberField *>())
      if (field->isVisible())
        names << field->accessibleName();
    names.sort();
    return names;
  }
  void type(const std::string &name, int axis, const QString &text) {
    NumberField *field = card.given().field(name, axis);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
  }
  /// What a label says; empty where it is hidden.
  QString said(const char *name) const {
    const auto *label = card.findChild<QLabel *>(name);
    return label->isVisible() ? label->text() : QString();
  }
  ExactVec3 value(const std::string &object, std::size_t index = 0) const {
    return coordinate(*findObject(model.session().scene, object), index);
  }

  Typesetter typesetter;
  SessionModel model;
  NumberCard card;
  bool ready = false;
};

const CoordinateId q0{"Q", 0};

} // namespace

class NumberCardTest : public QObject {
  Q_OBJECT

private slots:
  void card_showsTheNumbersOfTheSelectedObject_andNoOthers() {
    ShownCard shown;
    QVERIFY(shown.ready);
    QCOMPARE(shown.fields(), QStringList());
    QVERIFY(!shown.card.property("framed").toBool());
    shown.card.setSelection(q0);
    QCOMPARE(shown.fields(), (QStringList{"Q x", "Q y", "Q z"}));
    QCOMPARE(shown.card.given().field("Q", 1)->text(), QString("15"));
    QVERIFY(shown.card.property("framed").toBool());
    QVERIFY(!shown.card.given().field("E.n", 0));
    shown.card.setSelection(CoordinateId{"E", 0});
    QCOMPARE(shown.fields(), (QStringList{"E.P0 x", "E.P0 y", "E.P0 z", "E.n x", "E.n y", "E.n z"}));
    shown.card.setSelection({});
    QCOMPARE(shown.fields(), QStringList());
  }

  void objectWithManyCoordinates_showsTheSelectedOneAlone() {
    ShownCard shown({{{"A", polygonOf({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}})}, triangleT()}});
    shown.card.setSelection(CoordinateId{"A", 2});
    QCOMPARE(shown.fields(), (QStringList{"A.P2 x", "A.P2 y", "A.P2 z"}));
    QCOMPARE(shown.card.given().field("A.P2", 1)->text(), QString("6"));
    shown.card.setSelection(CoordinateId{"A", 3});
    QCOMPARE(shown.fields().size(), 3);
    QVERIFY(shown.card.given().field("A.P3", 0));
    shown.card.setSelection(CoordinateId{"T", 1});
    QCOMPARE(shown.fields().size(), 9);
  }

  void typedNumber_changesTheSessionOnce() {
    ShownCard shown;
    QVERIFY(shown.ready);
    shown.card.setSelection(q0);
    shown.type("Q", 0, "-10/3");
    QTest::keyClick(shown.card.given().field("Q", 0), Qt::Key_Return);
    QVERIFY(shown.value("Q") == ExactVec3(q(-10, 3), 15, 8));
    QCOMPARE(shown.model.history().count(), 1);
    shown.model.history().undo();
    QCOMPARE(shown.card.given().field("Q", 0)->text(), QString("11"));
  }

  void arrowKeyAndScrub_stepTheNumber() {
    ShownCard shown;
    QVERIFY(shown.ready);
    shown.card.setSelection(q0);
    QTest::keyClick(shown.card.given().field("Q", 2), Qt::Key_Up);
    QVERIFY(shown.value("Q").z == 9);
    dragPointer(*shown.card.given().field("Q", 0), {20, 8}, {44, 8});
    QVERIFY(shown.value("Q").x == 14);
    QCOMPARE(shown.model.history().count(), 2);
  }

  void refusedText_isComplainedOf_untilItIsMended() {
    ShownCard shown;
    QVERIFY(shown.ready);
    shown.card.setSelection(q0);
    QCOMPARE(shown.said("complaint"), QString());
    shown.type("Q", 1, "seven");
    QTest::keyClick(shown.card.given().field("Q", 1), Qt::Key_Return);
    QVERIFY2(shown.said("complaint").contains("seven"), qPrintable(shown.said("complaint")));
    shown.type("Q", 1, "7");
    QTest::keyClick(shown.card.given().field("Q", 1), Qt::Key_Return);
    QCOMPARE(shown.said("complaint"), QString());
  }

  void typedNumbers_enteredFromOutside_areTaken_andTheFirstRefusalIsTold() {
    ShownCard shown;
    QVERIFY(shown.ready);
    shown.card.setSelection(q0);
    shown.type("Q", 0, "six");
    shown.type("Q", 2, "9");
    const QString why = shown.card.given().enterTyped();
    QVERIFY2(why.contains("six"), qPrintable(why));
    QVERIFY(shown.value("Q") == ExactVec3(11, 15, 9));
    shown.card.given().dropTyped();
    QCOMPARE(shown.card.given().field("Q", 0)->text(), QString("11"));
    QCOMPARE(shown.card.given().enterTyped(), QString());
  }

  void objectThatGoes_takesItsNumbersAlong_andBringsThemBack() {
    ShownCard shown({{pointQ(), planeE()}});
    shown.card.setSelection(q0);
    QVERIFY(shown.model.history().edit(RemoveEntry{"Q"}, "remove").isEmpty());
    QCOMPARE(shown.fields(), QStringList());
    shown.model.history().undo();
    QCOMPARE(shown.fields(), (QStringList{"Q x", "Q y", "Q z"}));
  }

  void numbersThatAreDragged_keepTheirFields() {
    ShownCard shown;
    shown.card.setSelection(q0);
    const NumberField *field = shown.card.given().field("Q", 0);
    QVERIFY(shown.model.history().edit(ChangeObject{"Q", PointObject{{q(1, 3), 0, 0}}}, "drag").isEmpty());
    QCOMPARE(shown.card.given().field("Q", 0), field);
    QCOMPARE(field->text(), QString("1/3"));
  }

  void hint_isCutShortWhereThereIsNoRoom_andWholeAgainWhereThereIs() {
    ShownCard shown;
    const QString hint = "Moves in x and y. Click it once more for z. Escape takes it back.";
    shown.card.setHint(hint);
    const int whole = shown.card.sizeHint().width();
    shown.card.resize(whole * 2 / 3, shown.card.height());
    QCOMPARE(shown.said("hint"), QString("Moves in x and y."));
    shown.card.resize(whole / 8, shown.card.height());
    QVERIFY2(shown.said("hint").endsWith(QChar(0x2026)), qPrintable(shown.said("hint")));
    QVERIFY(shown.card.sizeHint().width() >= whole - 1); // it takes the room where it gets it
    shown.card.resize(whole, shown.card.height());
    QCOMPARE(shown.said("hint"), hint);
    shown.card.setHint({});
    QCOMPARE(shown.said("hint"), QString());
  }

  void largerType_makesWiderFields() {
    ShownCard shown;
    shown.card.setSelection(q0);
    const int usual = shown.card.given().field("Q", 0)->width();
    const QFont before = QApplication::font();
    QFont large = before;
    large.setPixelSize(2 * QFontInfo(before).pixelSize());
    QApplication::setFont(large);
    shown.card.setTheme(themes().front());
    QVERIFY(shown.card.given().field("Q", 0)->width() > 1.5 * usual);
    QApplication::setFont(before);
  }
};

QTEST_MAIN(NumberCardTest)
#include "number_card_test.moc"
