// Where the keys take a handle: along the axes as the camera shows them.
#include "widgets/view/key_steps.h"

#include <QtTest>

#include <numbers>

using namespace halfspace;

Q_DECLARE_METATYPE(halfspace::ExactVec3)

namespace {

const ExactVec3 start(11, 15, 8);

Camera lookingFrom(double azimuth, double elevation = 0.4) {
  Camera camera;
  camera.azimuth = azimuth;
  camera.elevation = elevation;
  return camera;
}

Handle freeHandle() {
  Handle handle;
  handle.at = start;
  return handle;
}

/// The way that a key makes.
ExactVec3 wayOf(int key, const Camera &camera, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
                const Rational &step = 1) {
  return *steppedPlace(freeHandle(), key, modifiers, step, camera) - start;
}

} // namespace

class KeyStepsTest : public QObject {
  Q_OBJECT

private slots:
  void arrowKeys_fromEachSide_goAsTheScreenShowsIt_data() {
    QTest::addColumn<double>("azimuth");
    QTest::addColumn<ExactVec3>("right");
    QTest::addColumn<ExactVec3>("up");
    const double quarter = std::numbers::pi / 2;
    const auto row = [](const char *name, double azimuth, const ExactVec3 &right, const ExactVec3 &up) {
      QTest::newRow(name) << azimuth << right << up;
    };
    row("from +x", 0, {0, 1, 0}, {-1, 0, 0});
    row("nearly from +x", 0.5, {0, 1, 0}, {-1, 0, 0});
    row("from +y", quarter, {-1, 0, 0}, {0, -1, 0});
    row("from -x", 2 * quarter, {0, -1, 0}, {1, 0, 0});
    row("from -y", 3 * quarter, {1, 0, 0}, {0, 1, 0});
  }

  void arrowKeys_fromEachSide_goAsTheScreenShowsIt() {
    QFETCH(double, azimuth);
    QFETCH(ExactVec3, right);
    QFETCH(ExactVec3, up);
    const Camera camera = lookingFrom(azimuth);
    QVERIFY(wayOf(Qt::Key_Right, camera) == right);
    QVERIFY(wayOf(Qt::Key_Left, camera) == -right);
    QVERIFY(wayOf(Qt::Key_Up, camera) == up);
    QVERIFY(wayOf(Qt::Key_Down, camera) == -up);
  }

  void arrowKeys_fromStraightAbove_stillGoUpTheScreen() {
    QVERIFY(wayOf(Qt::Key_Up, lookingFrom(0, Camera::maxElevation)) == ExactVec3(-1, 0, 0));
  }

  void pageKeys_fromAnywhere_goAlongZ() {
    for (const double azimuth : {0.0, 2.0, 4.0}) {
      QVERIFY(wayOf(Qt::Key_PageUp, lookingFrom(azimuth)) == ExactVec3(0, 0, 1));
      QVERIFY(wayOf(Qt::Key_PageDown, lookingFrom(azimuth, -1)) == ExactVec3(0, 0, -1));
    }
  }

  void step_withShiftOrCtrl_isExactlyATenthOrTenOfThem() {
    const Camera camera = lookingFrom(0);
    const Rational step(1, 4);
    QVERIFY(wayOf(Qt::Key_Right, camera, Qt::NoModifier, step).y == Rational(1, 4));
    QVERIFY(wayOf(Qt::Key_Right, camera, Qt::ShiftModifier, step).y == Rational(1, 40));
    QVERIFY(wayOf(Qt::Key_Right, camera, Qt::ControlModifier, step).y == Rational(5, 2));
  }

  void handle_withAnAxis_movesAlongItAlone() {
    Handle handle = freeHandle();
    handle.axis = {1, 2, 2};
    const Camera camera = lookingFrom(0);
    const auto way = [&](int key) { return *steppedPlace(handle, key, Qt::NoModifier, 2, camera) - start; };
    QVERIFY(way(Qt::Key_PageUp) == ExactVec3(2, 4, 4));
    QVERIFY(way(Qt::Key_Right) == ExactVec3(2, 4, 4));
    QVERIFY(way(Qt::Key_Left) == ExactVec3(-2, -4, -4));
  }

  void otherKeys_moveNothing() {
    for (const int key : {Qt::Key_Home, Qt::Key_Return, Qt::Key_X, Qt::Key_Space})
      QVERIFY(!steppedPlace(freeHandle(), key, Qt::NoModifier, 1, lookingFrom(0)));
  }
};

QTEST_GUILESS_MAIN(KeyStepsTest)
#include "key_steps_test.moc"
