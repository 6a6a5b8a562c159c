// The numbers of a session: rows made from its scene, and what typing, sliding and scrubbing there does to
// it.
#include "widgets/numbers/inspector.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "tests/lessons/scenes.h"
#include "tests/widgets/pointer.h"
#include "widgets/numbers/named_value_row.h"
#include "widgets/numbers/number_field.h"

#include <QLabel>
#include <QPointer>
#include <QSlider>

using namespace halfspace;
using namespace halfspace::test;

namespace {

LessonLibrary libraryOf(Scene scene) {
  Lesson lesson;
  lesson.id = "x";
  lesson.scene = std::move(scene);
  return {{lesson}, {}};
}

/// A shown inspector that follows a session.
struct ShownInspector {
  explicit ShownInspector(Scene scene) : model(libraryOf(std::move(scene))), inspector(model, typesetter) {
    QObject::connect(&model, &SessionModel::outcomeChanged, &inspector, &Inspector::showSession);
    inspector.resize(420, 700);
    inspector.showSession();
    inspector.show();
    ready = QTest::qWaitForWindowActive(&inspector);
  }

  NumberField &field(const std::string &name, int axis) { return *inspector.given().field(name, axis); }
  void type(NumberField &into, const QString &text) {
    into.setFocus();
    into.selectAll();
    QTest::keyClicks(&into, text);
  }
  void enter(NumberField &into, const QString &text) {
    type(into, text);
    QTest::keyClick(&into, Qt::Key_Return);
  }
  ExactVec3 value(const std::string &object, std::size_t index = 0) {
    return coordinate(*findObject(model.session().scene, object), index);
  }

  /// What the row with this name says; empty where there is none.
  QString result(const QString &name) {
    for (NamedValueRow *row : inspector.findChildren<NamedValueRow *>())
      if (row->isVisible() && row->name().accessibleName() == name)
        return row->value().accessibleName();
    return {};
  }
  QStringList headings() {
    QStringList texts;
    for (QLabel *label : inspector.findChildren<QLabel *>("heading"))
      if (label->isVisible())
        texts << label->text();
    return texts;
  }
  /// The sentence that is shown; empty for none.
  QString complaint() {
    auto *label = inspector.findChild<QLabel *>("complaint");
    return label->isVisible() ? label->text() : QString();
  }

  Typesetter typesetter;
  SessionModel model;
  Inspector inspector;
  bool ready = false;
};

Scene sceneWithNumber(const NumberObject &number) { return {{{"k", number}}}; }

/// A scene of more points than are listed.
Scene manyPoints(int count) {
  Scene scene;
  for (int i = 0; i < count; ++i)
    scene.entries.push_back({"A" + std::to_string(i), PointObject{{i, 0, 0}}});
  return scene;
}

/// A box with a ray, whose line has a product with each of twelve edges.
Scene boxScene() {
  return sceneOf(*findConstruction("ray-solid-pluecker"),
                 {*makeObject("box"), RayObject{{1, 0, 20}, {20, 20, 11}}});
}

Scene sphereScene() {
  Object sphere = *makeObject("sphere");
  sphere[1].x = 3;
  return {{{"S", sphere}}};
}

} // namespace

class InspectorTest : public QObject {
  Q_OBJECT

private slots:
  void hidden_whileTheSceneIsMoved_makesNothing_andWritesItOnceItIsSeen() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    shown.inspector.hide();
    shown.model.history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "edit");
    const auto &values = shown.model.evaluation().find("distance")->outcome->values;
    QVERIFY(!values.isMade());
    QCOMPARE(shown.field("Q", 0).text(), QString("11"));
    shown.inspector.show();
    QVERIFY(values.isMade());
    QCOMPARE(shown.field("Q", 0).text(), QString("1"));
  }

  void rows_ofAScene_haveAFieldForEachNumber() {
    ShownInspector shown(sphereScene());
    QCOMPARE(shown.inspector.findChildren<NumberField *>().size(), 4);
    QCOMPARE(shown.field("S.R", 0).text(), QString("3"));
    QCOMPARE(shown.field("S.R", 0).accessibleName(), QString("S.R"));
    QCOMPARE(shown.field("S.c", 2).accessibleName(), QString("S.c z"));
    QVERIFY(!shown.inspector.given().field("S.n", 0));
  }

  void number_typed_changesTheSessionOnce_andItsResults() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    const QString before = shown.result("f(Q)");
    QVERIFY(!before.isEmpty());
    shown.enter(shown.field("Q", 0), "5");
    QVERIFY(shown.value("Q") == ExactVec3(5, 15, 8));
    QCOMPARE(shown.model.history().count(), 1);
    QCOMPARE(shown.result("f(Q)"), QString("= 24"));
  }

  void numbers_ofOnePoint_areAllDecimalsOrAllFractions() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    shown.enter(shown.field("Q", 0), "2.5");
    QCOMPARE(shown.field("Q", 0).text(), QString("2.5"));
    shown.enter(shown.field("Q", 1), "1/3");
    QCOMPARE(shown.field("Q", 0).text(), QString("5/2"));
    QCOMPARE(shown.field("Q", 1).text(), QString("1/3"));
    shown.enter(shown.field("Q", 1), "1/4");
    QCOMPARE(shown.field("Q", 0).text(), QString("2.5"));
    QCOMPARE(shown.field("Q", 1).text(), QString("0.25"));
  }

  void result_thatIsAFraction_isShownWithItsDecimal() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    shown.enter(shown.field("Q", 0), "6"); // (6−5) + 2(15−4) + 2(8−7) = 25, over 3
    QCOMPARE(shown.result("dist"), QString::fromUtf8("= 25/3 ≈ 8.33333"));
  }

  void result_thatIsALongList_isWrappedAndReadWhole() {
    ShownInspector shown(boxScene());
    QVERIFY(shown.ready);
    const auto rows = shown.inspector.findChildren<NamedValueRow *>();
    const auto row = std::find_if(rows.begin(), rows.end(), [](NamedValueRow *each) {
      return each->name().accessibleName().startsWith(QString::fromUtf8("(p₀, p₁"));
    });
    QVERIFY(row != rows.end());
    for (const int width : {260, 420, 900}) {
      shown.inspector.resize(width, 700);
      QCoreApplication::processEvents();
      const MathLabel &value = (*row)->value();
      QVERIFY(value.width() >= value.narrowestWidth());
      QVERIFY(QRect(QPoint(), (*row)->size()).contains(value.geometry()));
      QVERIFY(value.height() >= value.heightForWidth(value.width()));
    }
  }

  void results_whileAQuestionAsks_areHidden() {
    ShownInspector shown(distanceScene());
    shown.inspector.setResultsHidden(true);
    shown.inspector.showSession();
    QCOMPARE(shown.result("f(Q)"), QString());
    shown.inspector.setResultsHidden(false);
    shown.inspector.showSession();
    QVERIFY(!shown.result("f(Q)").isEmpty());
  }

  void results_ofSeveralConstructions_standUnderTheirNames() {
    Scene scene = distanceScene();
    QVERIFY(!ShownInspector(scene).headings().contains("distance"));
    scene.entries.push_back({"R", PointObject{{1, 1, 1}}});
    scene.entries.push_back({"other", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "R"}}}});
    ShownInspector shown(scene);
    const QStringList headings = shown.headings();
    QVERIFY(headings.indexOf("other") > headings.indexOf("distance") && headings.contains("distance"));
  }

  void fields_whenTheResultsAreOthers_stay() {
    ShownInspector shown(
        {{planeE(), rayL(), {"hit", ConstructionUse{"ray-plane-dot", {{"E", "E"}, {"L", "L"}}}}}});
    QVERIFY(shown.ready);
    const int before = shown.inspector.findChildren<NamedValueRow *>().size();
    const QPointer<NumberField> field = &shown.field("L.r", 0);
    QCOMPARE(shown.model.history().edit(ChangeObject{"L", RayObject{{11, 15, 8}, {-4, 1, 1}}}, "parallel"),
             QString());
    QTRY_VERIFY(shown.inspector.findChildren<NamedValueRow *>().size() != before);
    QCOMPARE(field.data(), &shown.field("L.r", 0));
    QCOMPARE(field->text(), QString("-4"));
  }

  void rows_whenAnObjectOfAnotherKindTakesTheName_areMadeAnew() {
    ShownInspector shown(sphereScene());
    QVERIFY(shown.model.history().edit(RemoveEntry{"S"}, "remove").isEmpty());
    QVERIFY(!shown.inspector.given().field("S.R", 0));
    QVERIFY(
        shown.model.history().edit(AddEntry{0, {"S", PlaneObject{{1, 2, 3}, {0, 0, 1}}}}, "add").isEmpty());
    QCOMPARE(shown.field("S.P0", 1).text(), QString("2"));
    shown.model.history().undo();
    shown.model.history().undo();
    QCOMPARE(shown.field("S.R", 0).text(), QString("3"));
  }

  void rows_ofVeryManyObjects_endWithTheNumberOfTheOthers() {
    ShownInspector shown(manyPoints(63));
    QVERIFY(shown.inspector.given().field("A59", 0));
    QVERIFY(!shown.inspector.given().field("A60", 0));
    QCOMPARE(shown.headings().filter("3 more").size(), 1);
    QVERIFY(ShownInspector(manyPoints(60)).headings().filter("more").isEmpty());
  }

  void refusedText_isComplainedOf_untilItIsMended() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    QCOMPARE(shown.complaint(), QString());
    shown.enter(shown.field("Q", 1), "seven");
    QVERIFY2(shown.complaint().contains("seven"), qPrintable(shown.complaint()));
    shown.enter(shown.field("Q", 1), "7");
    QCOMPARE(shown.complaint(), QString());
  }

  void typedNumbers_enteredFromOutside_areTaken_andTheFirstRefusalIsTold() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    shown.type(shown.field("E.P0", 0), "six");
    shown.type(shown.field("Q", 2), "9");
    const QString why = shown.inspector.given().enterTyped();
    QVERIFY2(why.contains("six"), qPrintable(why));
    QVERIFY(shown.value("Q") == ExactVec3(11, 15, 9));
    shown.inspector.given().dropTyped();
    QCOMPARE(shown.field("E.P0", 0).text(), QString("5"));
    QCOMPARE(shown.inspector.given().enterTyped(), QString());
  }

  void arrowKey_inAPosition_movesByTheSnappingStep() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    shown.model.snapping().step = Rational(1, 4);
    shown.field("Q", 2).setFocus();
    QTest::keyClick(&shown.field("Q", 2), Qt::Key_Down);
    QVERIFY(shown.value("Q") == ExactVec3(11, 15, q(31, 4)));
  }

  void arrowKey_inALongDirection_movesByAStepOfItsSize() {
    ShownInspector shown({{{"E", PlaneObject{{5, 4, 7}, {1000, 2000, 2000}}}}});
    QVERIFY(shown.ready);
    shown.field("E.n", 0).setFocus();
    QTest::keyClick(&shown.field("E.n", 0), Qt::Key_Up);
    QVERIFY(shown.value("E", 1).x == 1100);
  }

  void scrub_ofAField_isOneUndoStep_andNoneWhenEscaped() {
    ShownInspector shown(distanceScene());
    QVERIFY(shown.ready);
    dragPointer(shown.field("Q", 0), {20, 8}, {44, 8});
    QVERIFY(shown.value("Q").x == 14);
    QCOMPARE(shown.model.history().count(), 1);
    QTest::mousePress(&shown.field("Q", 0), Qt::LeftButton, {}, {20, 8});
    movePointer(shown.field("Q", 0), {60, 8}, Qt::LeftButton);
    QVERIFY(shown.value("Q").x == 19);
    QTest::keyClick(&shown.field("Q", 0), Qt::Key_Escape);
    QVERIFY(shown.value("Q").x == 14);
    QCOMPARE(shown.model.history().count(), 1);
  }

  void slider_ofABoundedNumber_stepsItByKeys() {
    ShownInspector shown(sceneWithNumber({1, -1, 2, q(1, 2)}));
    QVERIFY(shown.ready);
    auto *slider = shown.inspector.findChild<QSlider *>();
    QVERIFY(slider);
    QCOMPARE(slider->maximum() - slider->minimum(), 6);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(shown.value("k").x == q(3, 2));
    QTest::keyClick(slider, Qt::Key_End);
    QVERIFY(shown.value("k").x == 2);
    QCOMPARE(shown.model.history().count(), 2);
  }

  void slider_heldAndMoved_isOneUndoStep() {
    ShownInspector shown(sceneWithNumber({1, -1, 2, q(1, 2)}));
    QVERIFY(shown.ready);
    auto *slider = shown.inspector.findChild<QSlider *>();
    slider->setSliderDown(true);
    for (const int position : {3, 1, 0})
      slider->setSliderPosition(position);
    QVERIFY(shown.model.history().inGesture());
    slider->setSliderDown(false);
    QVERIFY(shown.value("k").x == -1);
    QCOMPARE(shown.model.history().count(), 1);
    shown.model.history().undo();
    QCOMPARE(slider->value(), 4);
  }

  void slider_ofANumberWithoutAStep_isNotThere() {
    ShownInspector shown(sceneWithNumber({1, -1, 2, 0}));
    QCOMPARE(shown.inspector.findChildren<NumberField *>().size(), 4);
    QVERIFY(!shown.inspector.findChild<QSlider *>());
  }

  void slider_whenTheBoundsChange_goesFromOneToTheOther() {
    ShownInspector shown(sceneWithNumber({2, -1, 2, q(1, 2)}));
    auto *slider = shown.inspector.findChild<QSlider *>();
    QCOMPARE(slider->value(), 6);
    QCOMPARE(shown.model.history().edit(ChangeObject{"k", NumberObject{1, 0, 5, 1}}, "bounds"), QString());
    QCOMPARE(slider->maximum(), 5);
    QCOMPARE(slider->value(), 1);
    QVERIFY(shown.value("k").x == 1); // showing it moved nothing
    QCOMPARE(shown.model.history().count(), 1);
  }
};

QTEST_MAIN(InspectorTest)
#include "inspector_test.moc"
