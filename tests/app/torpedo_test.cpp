// The photon torpedo in the real window: flown by its controls, aimed by the mouse, with meshes of one's own.
#include "tests/app/box_answerer.h"
#include "tests/app/window_fixture.h"
#include "tests/widgets/pointer.h"

#include "geometry/decide.h"
#include "geometry/hit_all.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/kinds/ufo.h"
#include "lessons/scene/target_mesh.h"
#include "widgets/flight/flight_axis.h"
#include "widgets/flight/flight_bar.h"
#include "widgets/hit_table/fragment_table.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/mesh_loader.h"

#include <QApplication>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>

#include <set>

namespace halfspace {
namespace {

constexpr int stepWithTable = 2;
constexpr int stepWithLoop = 4;
constexpr int patience = 10000; // milliseconds

/// The rows of the table by their fragments' numbers.
std::vector<std::size_t> rowsOf(const FragmentTable &table) {
  std::vector<std::size_t> numbers;
  for (const FragmentRow &row : table.rows())
    numbers.push_back(row.crossing.number);
  return numbers;
}

/// The triangles of all meshes of the scene, in the order in which they are numbered.
std::vector<Triangle<Rational>> trianglesIn(const Scene &scene) {
  std::vector<Triangle<Rational>> triangles;
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content))
      if (const auto mesh = objectAs<MeshObject>(*object))
        for (std::size_t i = 0; i < mesh->shape->triangleCount(); ++i)
          triangles.push_back(triangleOf(*mesh, i));
  return triangles;
}

} // namespace

class TorpedoTest : public QObject {
  Q_OBJECT

private slots:
  void init() {
    forgetStarts();
    m_fixture = std::make_unique<WindowFixture>("photon-torpedo");
    QVERIFY(m_fixture->ready);
  }
  void cleanup() { m_fixture.reset(); }

  void table_barrelDraggedByMouse_isSortedAnewAsTheExactLoopSaysItIs() {
    m_fixture->model().setStep(stepWithTable);
    QCoreApplication::processEvents();
    const auto &table = *m_fixture->window.findChild<FragmentTable *>();
    const std::vector<std::size_t> before = rowsOf(table);
    const ExactVec3 start = m_fixture->value("U.S");
    const ExactVec3 tip = start + m_fixture->value("U.g");
    m_fixture->drag(m_fixture->pixelOf(toDouble(tip)),
                    m_fixture->pixelOf(toDouble(ExactVec3(tip + ExactVec3(1, -2, 0)))));
    QVERIFY(m_fixture->value("U.g") != ExactVec3(4, 2, -4));
    QVERIFY(rowsOf(table) != before);

    const RayObject ray =
        objectAs<RayObject>(m_fixture->model().evaluation().find("shot")->outcome->objects.at(0).object)
            .value();
    const auto triangles = trianglesIn(m_fixture->model().session().scene);
    const auto hits =
        hitAll(Ray<Rational>{ray.origin, ray.direction}, std::span<const Triangle<Rational>>(triangles)).hits;
    std::vector<std::size_t> expected;
    for (const auto &hit : hits)
      expected.push_back(hit.index + 1);
    std::vector<std::size_t> shown;
    std::optional<Rational> last;
    for (const FragmentRow &row : table.rows()) {
      if (row.crossing.which == RayTriangleCase::Hit)
        shown.push_back(row.crossing.number);
      if (row.crossing.at) {
        QVERIFY(!last || *last <= row.crossing.at->t);
        last = row.crossing.at->t;
      }
    }
    QCOMPARE(shown, expected);
  }

  void barrelDragged_whileTheTorpedoFlies_endsTheFlightAndIsDragged() {
    m_fixture->answer(2);
    const auto &bar = *m_fixture->window.findChild<FlightBar *>();
    const QPoint tip = m_fixture->pixelOf(toDouble(m_fixture->value("U.S") + m_fixture->value("U.g")));
    QTest::mouseClick(&bar.button(FlightControl::Play), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_fixture->value("frame").x > 2, patience);
    m_fixture->press(tip);
    QVERIFY(!bar.state().isPlaying);
    m_fixture->moveTo(tip + QPoint(60, 30));
    m_fixture->release();
    QVERIFY(m_fixture->value("U.g") != ExactVec3(4, 2, -4));
    m_fixture->model().history().undo();
    QCOMPARE(m_fixture->value("U.g"), ExactVec3(4, 2, -4));
    QVERIFY(m_fixture->value("frame").x > 2);
  }

  void row_clicked_choosesTheFragmentThatIsWorkedOut() {
    m_fixture->model().setStep(stepWithTable);
    QCoreApplication::processEvents();
    auto &table = *m_fixture->window.findChild<FragmentTable *>();
    const std::size_t row = table.rows().size() - 2;
    const std::size_t number = table.rows()[row].crossing.number;
    QVERIFY(Rational(static_cast<int>(number)) != m_fixture->value("i").x);
    QTest::mouseClick(&table, Qt::LeftButton, {}, table.rowRect(row).center());
    QCOMPARE(m_fixture->value("i").x, Rational(static_cast<int>(number)));
    const auto triangles = trianglesIn(m_fixture->model().session().scene);
    const auto made = objectAs<TriangleObject>(
        m_fixture->model().evaluation().find("nearest")->outcome->objects.back().object);
    QCOMPARE(made->p0, triangles[number - 1].p0);
    QCOMPARE(made->p2, triangles[number - 1].p2);
  }

  void flight_playedToItsEnd_followsTheClockExplodesAndIsOneUndoStep() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    const int undoSteps = m_fixture->model().history().index();
    emit bar.speedChanged(2);
    QElapsedTimer clock;
    clock.start();
    QTest::mouseClick(&bar.button(FlightControl::Play), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_fixture->value("frame").x > 20, patience);
    // The frame is that of the clock, however few pictures were drawn.
    const double seconds = static_cast<double>(clock.elapsed()) * 1e-3;
    QVERIFY(toDouble(m_fixture->value("frame").x) <= seconds * 2 * 25 + 1);
    QTRY_COMPARE_WITH_TIMEOUT(m_fixture->model().evaluation().find("flight")->outcome->told->name,
                              std::string("exploded"), patience);
    QTRY_VERIFY_WITH_TIMEOUT(!bar.state().isPlaying, patience);
    QCOMPARE(m_fixture->model().history().index(), undoSteps + 1);
    m_fixture->model().history().undo();
    QCOMPARE(m_fixture->value("frame").x, Rational(0));
  }

  void axis_scrubbed_movesTheTorpedoAndIsOneUndoStep() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    const int undoSteps = m_fixture->model().history().index();
    emit bar.axis().scrubBegun();
    for (const double t : {0.125, 0.25, 0.5})
      emit bar.axis().scrubbed(t);
    emit bar.axis().scrubEnded(true);
    QCOMPARE(m_fixture->value("frame").x, Rational(25));
    QCOMPARE(bar.state().t, 0.5);
    QCOMPARE(m_fixture->model().history().index(), undoSteps + 1);
  }

  void axis_scrubbedBehindTheHit_leavesTheTorpedoAtIt_whileTheExplosionGrows() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    const Crossing *hit = nearestOf(*m_fixture->model().evaluation().find("nearest")->outcome->crossings);
    QVERIFY(hit);
    const double t = toDouble(hit->at->t);
    emit bar.axis().scrubBegun();
    emit bar.axis().scrubbed(t - 0.125);
    QVERIFY(bar.state().t < t);
    emit bar.axis().scrubbed(t + 0.25);
    QCOMPARE(bar.state().t, t);
    QVERIFY(toDouble(m_fixture->value("frame").x) > 50 * t);
    emit bar.axis().scrubEnded(true);
  }

  void keysOnTheAxis_goOnBehindTheHit_andBackToIt() {
    m_fixture->answer(2);
    auto &axis = *m_fixture->window.findChild<FlightAxis *>();
    const Crossing *hit = nearestOf(*m_fixture->model().evaluation().find("nearest")->outcome->crossings);
    const double t = toDouble(hit->at->t);
    emit axis.scrubBegun();
    emit axis.scrubbed(t);
    emit axis.scrubEnded(true);
    const Rational atHit = m_fixture->value("frame").x;
    QTest::keyClick(&axis, Qt::Key_Right);
    const Rational behind = m_fixture->value("frame").x;
    QVERIFY(behind > atHit);
    QTest::keyClick(&axis, Qt::Key_Right);
    QVERIFY(m_fixture->value("frame").x > behind);
    QTest::keyClick(&axis, Qt::Key_Left);
    QCOMPARE(m_fixture->value("frame").x, behind);
  }

  void axis_scrubbedOntoTheHit_explodesThereWithAShortFrame() {
    m_fixture->answer(2);
    UfoObject saucer = objectAs<UfoObject>(*findObject(m_fixture->model().session().scene, "U")).value();
    saucer.barrel = {4, 2, -5}; // its λ is in no hundredth of a frame
    m_fixture->model().history().edit(ChangeObject{"U", saucer}, "test");
    const Crossing *hit = nearestOf(*m_fixture->model().evaluation().find("nearest")->outcome->crossings);
    QVERIFY(hit);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    emit bar.axis().scrubBegun();
    emit bar.axis().scrubbed(toDouble(hit->at->t));
    emit bar.axis().scrubEnded(true);
    QCOMPARE(m_fixture->model().evaluation().find("flight")->outcome->told->name, std::string("exploded"));
    QCOMPARE(Rational(m_fixture->value("frame").x * 100).denominator(), 1);
  }

  void axis_scrubbedAndLeftByEscape_isAsBefore() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    const int undoSteps = m_fixture->model().history().index();
    emit bar.axis().scrubBegun();
    emit bar.axis().scrubbed(0.5);
    QCOMPARE(m_fixture->value("frame").x, Rational(25));
    emit bar.axis().scrubEnded(false);
    QCOMPARE(m_fixture->value("frame").x, Rational(0));
    QCOMPARE(m_fixture->model().history().index(), undoSteps);
  }

  void fire_inAFlight_beginsItAnewAndIsOneUndoStep() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    emit bar.axis().scrubBegun();
    emit bar.axis().scrubbed(0.5);
    emit bar.axis().scrubEnded(true);
    const int undoSteps = m_fixture->model().history().index();
    emit bar.fire();
    QVERIFY(bar.state().isPlaying);
    QVERIFY(m_fixture->value("frame").x < 25);
    emit bar.playToggled(false);
    QCOMPARE(m_fixture->model().history().index(), undoSteps + 1);
    m_fixture->model().history().undo();
    QCOMPARE(m_fixture->value("frame").x, Rational(25));
  }

  void fire_whileTheQuestionIsOpen_doesNothing() {
    const auto &bar = *m_fixture->window.findChild<FlightBar *>();
    QTest::mouseClick(&bar.button(FlightControl::Fire), Qt::LeftButton);
    QVERIFY(!bar.state().isPlaying);
    m_fixture->answer(2);
    QTest::mouseClick(&bar.button(FlightControl::Fire), Qt::LeftButton);
    QVERIFY(bar.state().isPlaying);
  }

  void automaticFire_withTheSameSeed_firesTheSameShots() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    std::set<std::string> hit; // the objects
    const auto directions = [&] {
      emit bar.automaticToggled(true);
      emit bar.playToggled(false);
      std::vector<ExactVec3> all;
      for (const int frame : {0, 150, 300, 450}) {
        NumberObject number =
            objectAs<NumberObject>(*findObject(m_fixture->model().session().scene, "frame")).value();
        number.value = frame;
        m_fixture->model().history().edit(ChangeObject{"frame", number}, "test");
        all.push_back(
            objectAs<RayObject>(m_fixture->model().evaluation().find("shot")->outcome->objects.at(0).object)
                ->direction);
        const Crossing *nearest =
            nearestOf(*m_fixture->model().evaluation().find("nearest")->outcome->crossings);
        hit.insert(nearest ? nearest->name.substr(0, nearest->name.find(' ')) : "nothing");
      }
      emit bar.automaticToggled(false);
      return all;
    };
    const auto first = directions();
    QCOMPARE(directions(), first);
    QVERIFY(first[0] != first[1] || first[1] != first[2]);
    for (const ExactVec3 &direction : first)
      QVERIFY(direction.z < 0);
    QCOMPARE(hit, (std::set<std::string>{"barn", "field", "roof"})); // as the first seed is meant to
  }

  void automaticFire_withAnotherSeed_beginsAnewWithIt_andRemembersIt() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    emit bar.automaticToggled(true);
    QVERIFY(bar.seed().isVisible());
    QCOMPARE(m_fixture->value("seed").x, Rational(bar.seed().value()));
    QTRY_VERIFY_WITH_TIMEOUT(m_fixture->value("frame").x > 5, patience);
    bar.seed().setValue(42);
    QCOMPARE(m_fixture->value("seed").x, Rational(42));
    QVERIFY(m_fixture->value("frame").x <= 5);
    QVERIFY(bar.state().isPlaying);
    emit bar.automaticToggled(false);
    QCOMPARE(m_fixture->value("seed").x, Rational(0));
    QVERIFY(!bar.seed().isVisible());
    emit bar.automaticToggled(true);
    QCOMPARE(m_fixture->value("seed").x, Rational(42));
  }

  void step_withoutControls_isEnteredWithTheSaucerAtItsStart_andFiresByHand() {
    m_fixture->answer(2);
    emit m_fixture->window.findChild<FlightBar *>()->automaticToggled(true);
    QVERIFY(m_fixture->value("seed").x != 0);
    QTRY_VERIFY_WITH_TIMEOUT(m_fixture->value("frame").x > 5, patience);
    m_fixture->model().setStep(stepWithTable);
    QTRY_COMPARE_WITH_TIMEOUT(m_fixture->value("seed").x, Rational(0), patience);
    QCOMPARE(m_fixture->value("frame").x, Rational(0));
    QCOMPARE(m_fixture->model().evaluation().find("shot")->outcome->told->name, std::string("by-hand"));
  }

  void flight_withoutMotion_isAFewStepsThatTellTheSame() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    m_fixture->window.findChild<QAction *>("motion")->setChecked(false);
    QVERIFY(!bar.button(FlightControl::Play).isEnabled());
    emit bar.stepped(1);
    QCOMPARE(m_fixture->value("frame").x, Rational(10));
    std::set<std::string> frames;
    const auto connection = QObject::connect(&m_fixture->model(), &SessionModel::outcomeChanged,
                                             [&] { frames.insert(toText(m_fixture->value("frame").x)); });
    emit bar.fire();
    QTRY_COMPARE_WITH_TIMEOUT(m_fixture->model().evaluation().find("flight")->outcome->told->name,
                              std::string("exploded"), patience);
    emit bar.playToggled(false);
    QObject::disconnect(connection);
    QVERIFY(frames.size() <= 8);
    for (const std::string &frame : frames)
      QCOMPARE(Rational(std::stoi(frame) % 10), Rational(0));
  }

  void table_keyDown_asksOneFragmentAfterTheOther_upToTheLast() {
    m_fixture->model().setStep(stepWithLoop);
    QCoreApplication::processEvents();
    auto &table = *m_fixture->window.findChild<FragmentTable *>();
    table.setFocus();
    QTest::mouseClick(&table, Qt::LeftButton, {}, table.rowRect(0).center());
    const std::size_t count = m_fixture->model().evaluation().find("nearest")->outcome->crossings->fragments;
    QVERIFY(count > FragmentTable::mostRows);
    for (std::size_t number = 1; number < count; ++number) {
      QCOMPARE(m_fixture->value("i").x, Rational(static_cast<int>(number)));
      QTest::keyClick(&table, Qt::Key_Down);
    }
    QCOMPARE(m_fixture->value("i").x, Rational(static_cast<int>(count)));
  }

  void meshFile_dropped_isOpened_severalFilesAreNot() {
    QTemporaryDir folder;
    const QString file = folder.filePath("corner.obj");
    QFile text(file);
    QVERIFY(text.open(QIODevice::WriteOnly));
    text.write("v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
    text.close();
    m_fixture->window.findChild<MeshLoader *>()->setProgram(HALFSPACE_PROGRAM);
    const auto drop = [&](const QList<QUrl> &urls) {
      QMimeData data;
      data.setUrls(urls);
      QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
      enter.ignore();
      QCoreApplication::sendEvent(&m_fixture->window, &enter);
      QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
      event.ignore();
      QCoreApplication::sendEvent(&m_fixture->window, &event);
      return enter.isAccepted() && event.isAccepted();
    };
    const QUrl url = QUrl::fromLocalFile(file);
    QVERIFY(!drop({url, url}));
    QVERIFY(!drop({QUrl("https://example.org/corner.obj")}));
    QVERIFY(drop({url}));
    QTRY_VERIFY_WITH_TIMEOUT(findObject(m_fixture->model().session().scene, targetName), patience);
  }

  void meshFile_opened_isATargetThatTheNearestHitLooksAt() {
    open("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 3\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 1 2 2\n");
    const auto mesh = objectAs<MeshObject>(*findObject(m_fixture->model().session().scene, targetName));
    QVERIFY(mesh);
    QCOMPARE(mesh->shape->triangleCount(), std::size_t(4)); // the one without an area is left out
    const auto &crossings = *m_fixture->model().evaluation().find("nearest")->outcome->crossings;
    QCOMPARE(crossings.fragments, trianglesIn(m_fixture->model().session().scene).size());
    QCOMPARE(crossings.all.size(), crossings.fragments);
    m_fixture->model().history().undo();
    QVERIFY(!findObject(m_fixture->model().session().scene, targetName));
  }

  void mesh_selected_getsAnotherBesideIt_whichIsDraggedAndTakenAwayAgain() {
    m_fixture->model().setStep(stepWithTable);
    const Scene before = m_fixture->model().session().scene;
    SceneView &view = m_fixture->scene();
    m_fixture->window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_fixture->window));
    view.setFocus();
    view.handles().select("wall.P");
    QTest::keyClick(&view, Qt::Key_D, Qt::ControlModifier);
    const ExactVec3 place = m_fixture->value("wallB.P");
    QCOMPARE(view.handles().selection().selectedId(), std::string("wallB.P"));
    QCOMPARE(m_fixture->model().evaluation().find("nearest")->outcome->crossings->fragments,
             trianglesIn(before).size() + 2);
    const QPoint pixel = m_fixture->pixelOf(toDouble(place));
    m_fixture->drag(pixel, pixel + QPoint(-40, -10));
    QVERIFY(m_fixture->value("wallB.P") != place);
    QVERIFY(m_fixture->model().session().scene != before);
    QTest::keyClick(&view, Qt::Key_Delete);
    QVERIFY(m_fixture->model().session().scene == before);
    view.handles().select("wall.P"); // the lesson speaks of it
    QTest::keyClick(&view, Qt::Key_Delete);
    QVERIFY(m_fixture->model().session().scene == before);
  }

  void meshFile_ofVeryManyTriangles_isGrabbedAnywhere_andFewMeshesStayInTheList() {
    m_fixture->model().setStep(stepWithTable);
    const std::size_t before = m_fixture->model().evaluation().find("nearest")->outcome->crossings->fragments;
    open(pyramid(16));
    const auto mesh = objectAs<MeshObject>(*findObject(m_fixture->model().session().scene, targetName));
    QVERIFY(mesh);
    QCOMPARE(mesh->shape->triangleCount(), std::size_t(512));
    const auto &crossings = *m_fixture->model().evaluation().find("nearest")->outcome->crossings;
    QCOMPARE(crossings.fragments, before + 512);
    QCOMPARE(crossings.all.size(), before); // those of the barn, and the one that is hit is among them
    const QPoint tip = m_fixture->pixelOf(toDouble(mesh->place) + Place(0, 0, 2 * toDouble(mesh->scale)));
    m_fixture->drag(tip + QPoint(0, 6), tip + QPoint(60, 6));
    QVERIFY(m_fixture->value(std::string(targetName) + ".P") != mesh->place);
  }

  void meshFile_opened_tellsItsSize_andWhetherASessionKeepsIt() {
    const auto &message = *m_fixture->window.findChild<QLabel *>("message");
    open(pyramid(16));
    QVERIFY2(message.text().startsWith("own: 512 triangles, 16 × 16 × 2 of"), qPrintable(message.text()));
    QVERIFY(!message.text().contains("Too large"));
    m_fixture->model().history().undo();
    open(pyramid(160));
    QVERIFY2(message.text().endsWith("Too large to be saved with the session."), qPrintable(message.text()));
  }

  void meshFile_openedTwice_isTheSameTarget() {
    open(pyramid(2));
    const Scene once = m_fixture->model().session().scene;
    QSignalSpy loaded(m_fixture->window.findChild<MeshLoader *>(), &MeshLoader::loaded);
    open(pyramid(2));
    QTRY_COMPARE_WITH_TIMEOUT(loaded.size(), 1, patience);
    QVERIFY(m_fixture->model().session().scene == once);
    QVERIFY(!QApplication::activeModalWidget());
  }

  void meshFile_thatComesDuringADrag_waitsUntilTheHandLetsGo() {
    m_fixture->model().setStep(stepWithTable);
    QCoreApplication::processEvents();
    QSignalSpy loaded(m_fixture->window.findChild<MeshLoader *>(), &MeshLoader::loaded);
    const QPoint tip = m_fixture->pixelOf(toDouble(m_fixture->value("U.S") + m_fixture->value("U.g")));
    m_fixture->press(tip);
    m_fixture->moveTo(tip + QPoint(30, 10));
    startOpening(pyramid(2));
    QTRY_COMPARE_WITH_TIMEOUT(loaded.size(), 1, patience);
    m_fixture->moveTo(tip + QPoint(60, 30));
    QVERIFY(m_fixture->model().history().inGesture());
    QVERIFY(!findObject(m_fixture->model().session().scene, targetName));
    m_fixture->release();
    QTRY_VERIFY_WITH_TIMEOUT(findObject(m_fixture->model().session().scene, targetName), patience);
  }

  void keys_whileThePageIsHidden_flyTheTorpedo() {
    m_fixture->answer(2);
    m_fixture->window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_fixture->window));
    QTest::keyClick(&m_fixture->window, Qt::Key_F9);
    QVERIFY(!m_fixture->window.findChild<FlightBar *>()->isVisible());
    QTest::keyClick(&m_fixture->window, Qt::Key_Period);
    QCOMPARE(m_fixture->value("frame").x, Rational(1));
    QTest::keyClick(&m_fixture->window, Qt::Key_Comma);
    QCOMPARE(m_fixture->value("frame").x, Rational(0));
    QTest::keyClick(&m_fixture->window, Qt::Key_T);
    QVERIFY(m_fixture->window.findChild<FlightBar *>()->state().isPlaying);
    QTest::keyClick(&m_fixture->window, Qt::Key_P);
    QVERIFY(!m_fixture->window.findChild<FlightBar *>()->state().isPlaying);
    m_fixture->model().setStep(stepWithTable); // which has no flight
    const Rational frame = m_fixture->value("frame").x;
    QTest::keyClick(&m_fixture->window, Qt::Key_Period);
    QCOMPARE(m_fixture->value("frame").x, frame);
  }

  void keyThatFires_whileANumberIsScrubbed_endsTheScrubAndGoesOnAlone() {
    m_fixture->answer(2);
    m_fixture->window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_fixture->window));
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    NumberField *field = m_fixture->field("U.S", 0);
    QVERIFY(field);
    const QPoint from = field->rect().center();
    QTest::mousePress(field, Qt::LeftButton, {}, from);
    test::movePointer(*field, from + QPoint(24, 0), Qt::LeftButton);
    const Rational scrubbed = m_fixture->value("U.S").x;
    QTest::keyClick(&m_fixture->window, Qt::Key_T);
    QVERIFY(bar.state().isPlaying);
    test::movePointer(*field, from + QPoint(80, 0), Qt::LeftButton);
    QCOMPARE(m_fixture->value("U.S").x, scrubbed);
    QTest::mouseRelease(field, Qt::LeftButton, {}, from + QPoint(80, 0));
    QVERIFY2(bar.state().isPlaying && m_fixture->model().history().inGesture(), "it belongs to the flight");
  }

  void flight_whenTheQuestionIsOpenedAgain_ends() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    emit bar.automaticToggled(true);
    QVERIFY(bar.state().isPlaying);
    emit m_fixture->window.findChild<LessonPage *>()->predictionReopened();
    QVERIFY(!bar.state().isPlaying);
    QVERIFY(!m_fixture->model().history().inGesture());
  }

  void automaticFire_ofASession_isGoneOnWithByItsSeed() {
    m_fixture->answer(2);
    auto &bar = *m_fixture->window.findChild<FlightBar *>();
    NumberObject seed =
        objectAs<NumberObject>(*findObject(m_fixture->model().session().scene, "seed")).value();
    seed.value = 42;
    m_fixture->model().history().edit(ChangeObject{"seed", seed}, "test");
    emit bar.automaticToggled(false);
    emit bar.automaticToggled(true);
    QCOMPARE(m_fixture->value("seed").x, Rational(42));
  }

  void loop_amongMoreTrianglesThanAreListed_saysWhatIsHitFirst_andAsksNone() {
    open(pyramid(16));
    m_fixture->model().setStep(stepWithLoop);
    QCoreApplication::processEvents();
    const auto &table = *m_fixture->window.findChild<FragmentTable *>();
    const bool isAnyFirst = std::any_of(table.rows().begin(), table.rows().end(), [](const FragmentRow &row) {
      return row.standing == Standing::First;
    });
    QVERIFY(isAnyFirst);
    for (const FragmentRow &row : table.rows())
      QVERIFY(row.standing != Standing::NotAsked);
  }

  void meshFile_broken_isToldAndTheSceneStays() {
    QTemporaryDir folder;
    const QString file = folder.filePath("broken.stl");
    QFile text(file);
    QVERIFY(text.open(QIODevice::WriteOnly));
    text.write(QByteArray(80, ' ') + QByteArray("\x10\x00\x00\x00short", 9));
    text.close();
    auto &loader = *m_fixture->window.findChild<MeshLoader *>();
    loader.setProgram(HALFSPACE_PROGRAM);
    const Scene before = m_fixture->model().session().scene;
    QSignalSpy failed(&loader, &MeshLoader::failed);
    const BoxAnswerer closer; // of the box that says why
    m_fixture->window.meshes().open(file);
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, patience);
    QVERIFY(failed.at(0).at(0).toString().startsWith("broken.stl: "));
    QVERIFY(m_fixture->model().session().scene == before);
  }

private:
  /// Of n × n cells of two triangles each; 2 units high above its rim.
  static std::string pyramid(int n) {
    std::string text;
    for (int row = 0; row <= n; ++row)
      for (int column = 0; column <= n; ++column) {
        const int fromTip = std::max(std::abs(2 * column - n), std::abs(2 * row - n));
        text += "v " + std::to_string(column) + " " + std::to_string(row) + " " +
                std::to_string(2.0 * (n - fromTip) / n) + "\n";
      }
    const auto corner = [n](int column, int row) { return " " + std::to_string(row * (n + 1) + column + 1); };
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const std::string first = corner(column, row);
        const std::string opposite = corner(column + 1, row + 1);
        text += "f" + first + corner(column + 1, row) + opposite + "\n";
        text += "f" + first + opposite + corner(column, row + 1) + "\n";
      }
    return text;
  }

  /// An OBJ file with this text, as the target.
  void open(const std::string &obj) {
    startOpening(obj);
    QTRY_VERIFY_WITH_TIMEOUT(findObject(m_fixture->model().session().scene, targetName), patience);
  }

  /// The file is there as long as the test goes on.
  void startOpening(const std::string &obj) {
    QFile file(m_folder.filePath("own.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(obj));
    file.close();
    m_fixture->window.findChild<MeshLoader *>()->setProgram(HALFSPACE_PROGRAM);
    m_fixture->window.meshes().open(file.fileName());
  }

  const QTemporaryDir m_folder;
  std::unique_ptr<WindowFixture> m_fixture;
};

} // namespace halfspace

QTEST_MAIN(halfspace::TorpedoTest)
#include "torpedo_test.moc"
