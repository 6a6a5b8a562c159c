// Where the camera stands at home.
#include "lessons/lesson.h"
#include "lessons/session.h"
#include "widgets/scene/ground.h"
#include "widgets/views.h"

#include <QTest>

using namespace halfspace;

class ViewsTest : public QObject {
  Q_OBJECT

private slots:
  void home_ofEveryLesson_showsFigureAndAxesWithRoomForLabels_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<QSize>("size");
    for (const Lesson &lesson : m_library.lessons)
      for (const QSize size : {QSize(880, 440), QSize(700, 300), QSize(1600, 1000)})
        QTest::newRow((lesson.id + " " + std::to_string(size.height())).c_str())
            << QString::fromStdString(lesson.id) << size;
  }

  void home_ofEveryLesson_showsFigureAndAxesWithRoomForLabels() {
    QFETCH(QString, id);
    QFETCH(QSize, size);
    const Lesson &lesson = *m_library.find(id.toStdString());
    const Figure figure = evaluate(lesson.scene).figure;
    const PixelSize pixels{size.width(), size.height()};
    const Camera camera = homeView(lesson.camera, figure, true, pixels, 1);
    std::vector<Place> places = placesOf(figure);
    for (const AxisEnds &axis : axisEnds(axesAround(figure)))
      places.push_back(axis.high);
    for (const Place &place : places) {
      const auto pixel = camera.project(place, pixels);
      QVERIFY(pixel);
      QVERIFY(pixel->x >= 29 && pixel->x <= size.width() - 29);
      QVERIFY(pixel->y >= 29 && pixel->y <= size.height() - 29);
    }
  }

  void ray_isFoundOnlyWhereItHasADirection() {
    Scene scene = m_library.find("ray-plane-dot")->scene;
    QVERIFY(firstRay(scene));
    coordinate(*findObject(scene, "L"), 1) = ExactVec3(0);
    QVERIFY(!firstRay(scene));
    QVERIFY(!firstRay(m_library.find("signed-distance")->scene));
  }

private:
  LessonLibrary m_library = readLessons(TEST_LESSONS_FOLDER);
};

QTEST_APPLESS_MAIN(ViewsTest)
#include "views_test.moc"
