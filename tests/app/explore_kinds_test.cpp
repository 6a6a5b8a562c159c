// Each kind of object in Explore by the mouse alone, by keys alone, and typed: the same exact entries.
#include "lessons/object/kinds/mesh.h"
#include "lessons/typed/look_words.h"
#include "tests/app/explore_fixture.h"
#include "widgets/mesh_loader.h"
#include "widgets/view/object_hand.h"
#include "widgets/view/object_tool_words.h"

#include <QTemporaryDir>

using namespace halfspace;

namespace {

/// What a tool is given, one after the other, and what comes of it, as it would be typed.
struct ToolUse {
  const char *tool;
  std::vector<glm::ivec3> places;
  QStringList lines;
};

const std::vector<ToolUse> toolUses{
    {"point", {{6, 4, 0}}, {"A = (6, 4, 0)"}},
    {"segment", {{2, 4, 0}, {8, 4, 0}}, {"A = (2, 4, 0)", "B = (8, 4, 0)", "s = segment(A, B)"}},
    {"line", {{2, 4, 0}, {8, 4, 0}}, {"A = (2, 4, 0)", "B = (8, 4, 0)", "g = line(A, B - A)"}},
    {"ray", {{2, 4, 0}, {8, 6, 0}}, {"A = (2, 4, 0)", "B = (8, 6, 0)", "r = ray(A, B - A)"}},
    {"vector", {{2, 4, 0}, {8, 6, 0}}, {"A = (2, 4, 0)", "B = (8, 6, 0)", "u = vector(A, B - A)"}},
    {"plane-through-points",
     {{2, 4, 0}, {8, 4, 0}, {2, 9, 0}},
     {"A = (2, 4, 0)", "B = (8, 4, 0)", "C = (2, 9, 0)", "E = plane(A, B, C)"}},
    {"plane-with-normal", {{2, 4, 0}, {2, 4, 5}}, {"A = (2, 4, 0)", "B = (2, 4, 5)", "E = plane(A, B - A)"}},
    {"triangle",
     {{2, 4, 0}, {8, 4, 0}, {2, 9, 0}},
     {"A = (2, 4, 0)", "B = (8, 4, 0)", "C = (2, 9, 0)", "T = triangle(A, B, C)"}},
    {"polygon",
     {{2, 4, 0}, {8, 4, 0}, {8, 9, 0}, {2, 9, 0}, {2, 4, 0}},
     {"A = (2, 4, 0)", "B = (8, 4, 0)", "C = (8, 9, 0)", "D = (2, 9, 0)", "p = polygon(A, B, C, D)"}},
    {"sphere",
     {{2, 4, 0}, {6, 4, 0}},
     {"A = (2, 4, 0)", "k = 4, 0 <= k <= 10, step 1/10", "S = sphere(A, k)"}},
    {"tetrahedron",
     {{2, 4, 0}, {8, 4, 0}, {2, 9, 0}, {2, 4, 5}},
     {"A = (2, 4, 0)", "B = (8, 4, 0)", "C = (2, 9, 0)", "D = (2, 4, 5)", "T = tetrahedron(A, B, C, D)"}},
    {"box",
     {{2, 4, 0}, {8, 9, 0}, {8, 9, 5}},
     {"A = (2, 4, 0)", "B = (8, 9, 0)", "C = (8, 9, 5)", "K = box(A, B.x - A.x, B.y - A.y, C.z - A.z)"}},
    {"prism",
     {{2, 4, 0}, {8, 4, 0}, {2, 9, 0}, {2, 4, 0}, {2, 4, 5}},
     {"A = (2, 4, 0)", "B = (8, 4, 0)", "C = (2, 9, 0)", "D = (2, 4, 5)", "p = prism(A, D - A, B, C)"}},
};

/// Something that points can lie on, where the mouse takes one, and the points.
struct HostUse {
  const char *name;
  QString host;
  glm::ivec3 place;
  QString clicked; ///< the point where the mouse is clicked, as it would be typed
};

const std::vector<HostUse> hostUses{
    {"plane", "E: z = 2", {4, 3, 2}, "A = point-on-plane(E, (4, 3, 2))"},
    {"line", "g = line((0, 4, 1), (2, 0, 0))", {6, 4, 1}, "A = point-on-line(g, 3)"},
    {"ray", "r = ray((0, 4, 1), (2, 0, 0))", {6, 4, 1}, "A = point-on-ray(r, 3)"},
    {"triangle",
     "T = triangle((0, 0, 1), (8, 0, 1), (0, 8, 1))",
     {2, 4, 1},
     "A = point-on-triangle(T, 1/4, 1/2)"},
};

class KindsFixture : public ExploreFixture {
public:
  QMenu &addMenu() { return *window.findChild<QMenu *>("add"); }
  QAction &tool(const QString &id) { return *window.findChild<QAction *>("add-" + id); }

  /// Chooses an item of the menu with the pointer …
  void clickTool(const QString &id) {
    addMenu().popup(window.mapToGlobal({10, 10}));
    QTest::mouseClick(&addMenu(), Qt::LeftButton, {}, addMenu().actionGeometry(&tool(id)).center());
  }
  /// … or with the arrow keys.
  void keyTool(const QString &id) {
    addMenu().popup(window.mapToGlobal({10, 10}));
    for (std::size_t i = 0; i <= objectTools().size() && addMenu().activeAction() != &tool(id); ++i)
      QTest::keyClick(&addMenu(), Qt::Key_Down);
    QTest::keyClick(&addMenu(), Qt::Key_Return);
  }
  void clickPlace(const glm::ivec3 &place) {
    const QPoint pixel = pixelOf(place);
    QMouseEvent move(QEvent::MouseMove, pixel, ExploreFixture::WindowFixture::scene().mapToGlobal(pixel),
                     Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&WindowFixture::scene(), &move);
    QTest::mouseClick(&WindowFixture::scene(), Qt::LeftButton, {}, pixel);
  }
  /// Goes from one place to the next with the arrow keys, and takes it with Enter.
  void keyPlace(const glm::ivec3 &way) {
    const auto step = [this](int count, Qt::Key forward, Qt::Key back) {
      for (int i = 0; i < std::abs(count); ++i)
        QTest::keyClick(&WindowFixture::scene(), count > 0 ? forward : back);
    };
    step(way.x, Qt::Key_Down, Qt::Key_Up); // x comes towards the eye
    step(way.y, Qt::Key_Right, Qt::Key_Left);
    step(way.z, Qt::Key_PageUp, Qt::Key_PageDown);
    QTest::keyClick(&WindowFixture::scene(), Qt::Key_Return);
  }
  /// The scene as it would be typed, whatever colours its objects keep while others come.
  QStringList plainScene() {
    QStringList lines;
    for (const Entry &entry : model().session().scene.entries)
      lines << QString::fromStdString(lineFor(withoutLook(entry)));
    return lines;
  }
  void undoAll() {
    while (model().history().index() > 0)
      model().history().undo();
  }
};

} // namespace

class ExploreKindsTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void tool_data() {
    QTest::addColumn<int>("place");
    for (std::size_t i = 0; i < toolUses.size(); ++i)
      QTest::newRow(toolUses[i].tool) << static_cast<int>(i);
  }
  void tool() {
    QFETCH(int, place);
    const ToolUse &use = toolUses.at(static_cast<std::size_t>(place));
    KindsFixture fixture;
    QVERIFY(fixture.ready);

    fixture.clickTool(use.tool);
    for (const glm::ivec3 &at : use.places)
      fixture.clickPlace(at);
    QCOMPARE(fixture.plainScene(), use.lines);
    fixture.undoAll();
    QCOMPARE(fixture.scene(), QStringList());
    for (const QString &line : use.lines)
      fixture.enter(line);
    QCOMPARE(fixture.plainScene(), use.lines);

    KindsFixture withKeys; // no pointer has been in its picture
    QVERIFY(withKeys.ready);
    withKeys.WindowFixture::scene().viewpoint().show(NamedView::Top); // in which arrow keys go along x and y
    withKeys.keyTool(use.tool);
    glm::ivec3 from(0);
    for (const glm::ivec3 &at : use.places) {
      // What is wanted above a place begins there.
      withKeys.keyPlace(at.z == 0 ? at - from : glm::ivec3(0, 0, at.z));
      from = at;
    }
    QCOMPARE(withKeys.plainScene(), use.lines);
  }

  void pointOn_data() {
    QTest::addColumn<int>("place");
    for (std::size_t i = 0; i < hostUses.size(); ++i)
      QTest::newRow(hostUses[i].name) << static_cast<int>(i);
  }
  void pointOn() {
    QFETCH(int, place);
    const HostUse &use = hostUses.at(static_cast<std::size_t>(place));
    KindsFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter(use.host);
    QTest::qWait(50);

    fixture.clickTool("point-on");
    fixture.clickPlace(use.place);
    QCOMPARE(fixture.scene(), (QStringList{use.host, use.clicked}));
    fixture.model().history().undo();

    // By keys: what is selected has a point among what fits.
    const QString word = use.clicked.section(" = ", 1).section('(', 0, 0);
    fixture.list().setFocus();
    QTest::keyClick(&fixture.list(), Qt::Key_Home);
    QPushButton *fit = fixture.fit(word + "(");
    QVERIFY(fit);
    fit->setFocus();
    QTest::keyClick(fit, Qt::Key_Space);
    QCoreApplication::processEvents();
    QCOMPARE(fixture.scene().size(), 2);
    QVERIFY(fixture.scene().back().startsWith("A = " + word));
    fixture.model().history().undo();

    fixture.enter(use.clicked);
    QCOMPARE(fixture.scene(), (QStringList{use.host, use.clicked}));
  }

  void numberAndPlaneByEquation_beginAsALine_thatEnterTakes() {
    KindsFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *title : {"&Number…", "Plane by its &equation…"}) {
      for (QAction *action : fixture.addMenu().actions())
        if (action->text() == QString::fromUtf8(title))
          action->trigger();
      QTest::keyClick(&fixture.field(), Qt::Key_Return);
    }
    QCOMPARE(fixture.scene(), (QStringList{"k = 1, 0 <= k <= 5, step 1/2", "E: x + 2y + 2z = 9"}));
  }

  void meshFile_opened_comesToTheScene_eachTimeUnderAnotherName() {
    KindsFixture fixture;
    QVERIFY(fixture.ready);
    QTemporaryDir folder;
    QFile file(folder.filePath("corner.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
    file.close();
    fixture.window.findChild<MeshLoader *>()->setProgram(HALFSPACE_PROGRAM);
    for (std::size_t count = 1; count <= 2; ++count) {
      fixture.window.meshes().open(file.fileName());
      QTRY_COMPARE(fixture.model().session().scene.entries.size(), count);
    }
    QVERIFY(isExplore(fixture.model()));
    for (const Entry &entry : fixture.model().session().scene.entries)
      QVERIFY(objectAs<MeshObject>(std::get<Object>(entry.content)));
  }
};

QTEST_MAIN(ExploreKindsTest)
#include "explore_kinds_test.moc"
