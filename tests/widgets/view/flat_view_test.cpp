// The flat picture: in the lesson that has one, live, and absent everywhere else.
#include "widgets/view/flat_view.h"

#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "tests/widgets/pointer.h"
#include "widgets/typeset/typesetter.h"

#include <QAction>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace halfspace;

namespace {

constexpr const char *lessonWithPicture = "ray-plane-picture";

struct FlatFixture {
  FlatFixture() : model(readLessons(TEST_LESSONS_FOLDER)), flat(model, typesetter) {
    model.openLesson(lessonWithPicture);
    flat.resize(300, 220);
    flat.show();
  }

  [[nodiscard]] glm::dvec2 pixelOf(const std::string &point) const {
    for (const Mark &mark : flat.figure().marks)
      if (const auto *found = std::get_if<PointMark>(&mark); found && found->id == point)
        return glm::dvec2(flat.view().camera.project(found->at, flat.view().size).value());
    return {-1, -1};
  }
  /// How much of the picture is not background.
  [[nodiscard]] int inked() {
    const QImage image = flat.grab().toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        count += image.pixel(x, y) != image.pixel(image.width() - 3, image.height() - 3) ? 1 : 0;
    return count;
  }

  Typesetter typesetter;
  SessionModel model;
  FlatView flat;
};

} // namespace

class FlatViewTest : public QObject {
  Q_OBJECT

private slots:
  void picture_isThereInItsLessonAlone() {
    FlatFixture fixture;
    for (const Lesson &lesson : fixture.model.library().lessons) {
      fixture.model.openLesson(lesson.id);
      QCOMPARE(fixture.flat.hasPicture(), lesson.flat.has_value());
      QCOMPARE(fixture.flat.isVisible(), lesson.flat.has_value());
    }
    fixture.model.openLesson(lessonWithPicture);
    QVERIFY(fixture.flat.hasPicture() && fixture.flat.isVisible());
    QVERIFY(fixture.inked() > 1000);
  }

  void drag_movesItsMarks_andNothingElse() {
    FlatFixture fixture;
    const glm::dvec2 start = fixture.pixelOf("L.Q");
    const glm::dvec2 plane = fixture.pixelOf("G.P0");
    const View before = fixture.flat.view();
    const GestureToken held = fixture.model.history().beginGesture("drag");
    fixture.model.history().moveGesture(held, ChangeObject{"L", RayObject{{5, 0, 3}, {3, 0, 3}}});
    QVERIFY(fixture.pixelOf("L.Q") != start);
    QVERIFY(fixture.flat.view() == before);
    QVERIFY(fixture.pixelOf("G.P0") == plane);
    fixture.model.history().cancelGesture(held);
    QVERIFY(fixture.pixelOf("L.Q") == start);
  }

  void handle_draggedInThePicture_movesInItsPage_onTheGrid_asOneUndoStep() {
    FlatFixture fixture;
    fixture.model.setStep(3); // with the ray whole
    fixture.flat.resize(460, 340);
    const auto start = [&] { return findObject(fixture.model.session().scene, "L")->operator[](0); };
    const ExactVec3 before = start();
    const ExactVec3 normal = cross(findObject(fixture.model.session().scene, "G")->operator[](1),
                                   findObject(fixture.model.session().scene, "L")->operator[](1));
    QSignalSpy grabbed(&fixture.flat, &FlatView::handleGrabbed);
    const glm::dvec2 pixel = fixture.pixelOf("L.Q");
    const QPoint from(qRound(pixel.x), qRound(pixel.y));
    test::dragPointer(fixture.flat, from, from + QPoint(60, 30));
    QCOMPARE(grabbed.last().first().toString(), QString("L.Q"));
    QVERIFY(start() != before);
    QVERIFY2(dot(normal, start() - before) == 0, "it leaves the page");
    const ExactVec3 place = start();
    QVERIFY(place.x.denominator() == 1 || place.y.denominator() == 1 || place.z.denominator() == 1);
    QCOMPARE(fixture.model.history().count(), 1);
    fixture.model.history().undo();
    QVERIFY(start() == before);
  }

  void drag_inThePicture_escaped_isTakenBack_andTheNormalStaysUpright() {
    FlatFixture fixture;
    const Session before = fixture.model.session();
    const glm::dvec2 pixel = fixture.pixelOf("L.Q");
    const QPoint from(qRound(pixel.x), qRound(pixel.y));
    QTest::mousePress(&fixture.flat, Qt::LeftButton, {}, from);
    test::movePointer(fixture.flat, from + QPoint(40, -20), Qt::LeftButton);
    QVERIFY(!(fixture.model.session() == before));
    QTest::keyClick(&fixture.flat, Qt::Key_Escape);
    QVERIFY(fixture.model.session() == before);
    QTest::mouseRelease(&fixture.flat, Qt::LeftButton, {}, from);
    QVERIFY(fixture.model.session() == before);
    QCOMPARE(fixture.model.history().count(), 0);
  }

  void openQuestion_leavesOnlyWhatIsGiven() {
    FlatFixture fixture;
    fixture.model.setQuestionOf([] { return Question::Open; });
    QVERIFY(!findMark(fixture.flat.figure(), "picture.B"));
    QVERIFY(findMark(fixture.flat.figure(), "L.Q"));
    fixture.model.setQuestionOf([] { return Question::Answered; });
    QVERIFY(findMark(fixture.flat.figure(), "picture.B"));
  }

  void zeroNormal_hasNoPicture_untilItIsOneAgain() {
    FlatFixture fixture;
    fixture.model.history().edit(ChangeObject{"G", PlaneObject{{1, 7, 6}, ExactVec3(0)}}, "zero");
    QVERIFY(!fixture.flat.hasPicture() && !fixture.flat.isVisible());
    fixture.model.history().undo();
    QVERIFY(fixture.flat.hasPicture() && fixture.flat.isVisible());
  }

  void folded_isItsTitleAlone() {
    FlatFixture fixture;
    const QSize room(800, 700);
    const QSize unfolded = fixture.flat.sizeIn(room);
    QSignalSpy changed(&fixture.flat, &FlatView::sizeChanged);
    QTest::mouseClick(fixture.flat.findChild<QToolButton *>("flatTitle"), Qt::LeftButton);
    QCOMPARE(changed.count(), 1);
    const QSize folded = fixture.flat.sizeIn(room);
    QVERIFY(folded.height() < unfolded.height() / 3);
    fixture.flat.unfolded().toggle();
    QCOMPARE(fixture.flat.sizeIn(room), unfolded);
  }

  void size_leavesTheSceneMostOfItsRoom_onAnyScreen() {
    FlatFixture fixture;
    for (const QSize room : {QSize(500, 400), QSize(820, 700), QSize(2500, 1900)}) {
      const QSize size = fixture.flat.sizeIn(room);
      QVERIFY(size.width() <= room.width() / 2 && size.height() <= room.height() / 2);
      QVERIFY(size.width() >= 200 && size.height() >= 140);
    }
    QVERIFY(fixture.flat.sizeIn(QSize(380, 300)).height() < 60); // its title alone
    fixture.flat.setSizeScale(2);
    QVERIFY(fixture.flat.sizeIn(QSize(2500, 1900)).width() > 500);
  }

  void pointUnderThePointer_isTold_andForgottenOutside() {
    FlatFixture fixture;
    QSignalSpy hovered(&fixture.flat, &FlatView::markHovered);
    const glm::dvec2 start = fixture.pixelOf("L.Q");
    test::movePointer(fixture.flat, QPoint(qRound(start.x), qRound(start.y)));
    QCOMPARE(hovered.last().first().toString(), QString("L.Q"));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&fixture.flat, &leave);
    QVERIFY(hovered.last().first().toString().isEmpty());
  }

  void describesItself() {
    FlatFixture fixture;
    QVERIFY(!fixture.flat.accessibleName().isEmpty());
    QVERIFY(fixture.flat.accessibleDescription().contains("n points up"));
  }
};

QTEST_MAIN(FlatViewTest)
#include "flat_view_test.moc"
