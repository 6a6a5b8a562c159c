// Meshes loaded beside the window: what is told of them, and what becomes of those that never end.
#include "widgets/mesh_loader.h"

#include "tests/mesh_files/mesh_texts.h"

#include <QElapsedTimer>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace halfspace;

namespace {

constexpr int longest = 30000;

/// A loader, files for it, and what it tells.
struct Loading {
  Loading() { loader->setProgram(MESH_CHILD); }

  QString file(const QString &name, const std::string &content) const {
    QString path = folder.filePath(name);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) ||
        file.write(content.data(), static_cast<qint64>(content.size())) < 0)
      qFatal("cannot write %s", qPrintable(path));
    return path;
  }
  [[nodiscard]] int ends() const { return loaded.count() + failed.count() + cancelled.count(); }
  [[nodiscard]] bool waitForEnd() const {
    return QTest::qWaitFor([&] { return ends() > 0; }, longest);
  }

  QTemporaryDir folder;
  std::unique_ptr<MeshLoader> loader = std::make_unique<MeshLoader>();
  QSignalSpy loaded{loader.get(), &MeshLoader::loaded};
  QSignalSpy failed{loader.get(), &MeshLoader::failed};
  QSignalSpy cancelled{loader.get(), &MeshLoader::cancelled};
  QSignalSpy progressed{loader.get(), &MeshLoader::progressed};
};

/// Triangles beside one another.
std::string manyTriangles(std::size_t count) {
  std::string stl = binaryStlHead(static_cast<std::uint32_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i % 1000);
    const std::size_t row = i / 1000;
    const auto y = static_cast<float>(row);
    addTo(stl, {Vec3<float>(x, y, 0), Vec3<float>(x + 1, y, 0), Vec3<float>(x, y + 1, 1)});
  }
  return stl;
}

} // namespace

class MeshLoaderTest : public QObject {
  Q_OBJECT

private slots:
  void goodFile_isLoaded() {
    Loading loading;
    loading.loader->start(loading.file("my thing.v2.stl", binaryStl(tetrahedronTriangles())));
    QVERIFY(loading.loader->isLoading());
    QVERIFY(loading.waitForEnd());
    QCOMPARE(loading.loaded.count(), 1);
    QVERIFY(!loading.loader->isLoading());
    const auto mesh = loading.loaded.at(0).at(0).value<LoadedMesh>();
    QCOMPARE(mesh.name, std::string("my thing.v2"));
    QCOMPARE(mesh.triangles, std::size_t(4));
    QCOMPARE(mesh.shape->mesh()->corners.size(), std::size_t(4));
  }

  void progress_goesUpThroughBothHalves() {
    Loading loading;
    loading.loader->start(loading.file("many.stl", manyTriangles(300'000)));
    QVERIFY(loading.waitForEnd());
    QCOMPARE(loading.loaded.count(), 1);
    double before = -1;
    QStringList told;
    for (const auto &news : loading.progressed) {
      QVERIFY(news.at(0).toDouble() >= before);
      before = news.at(0).toDouble();
      told.append(news.at(1).toString());
    }
    told.removeDuplicates();
    QCOMPARE(told, (QStringList{"Reading the file", "Making the mesh ready"}));
    QVERIFY(before <= 1);
  }

  void badFile_fails_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("empty") << "a.stl" << QByteArray() << "The file is empty.";
    QTest::newRow("no mesh") << "a.txt" << QByteArray("Dear diary") << "This is no mesh";
    QTest::newRow("one point") << "a.obj" << QByteArray("v 1 1 1\nf 1 1 1\n") << "1 have no area";
    QTest::newRow("crash") << "crash.stl" << QByteArray("x") << "ended too early";
    QTest::newRow("silent") << "silent.stl" << QByteArray("x") << "ended too early";
    QTest::newRow("half") << "half.stl" << QByteArray("x") << "ended too early";
    QTest::newRow("rubbish") << "rubbish.stl" << QByteArray("x") << "is no mesh";
  }

  void badFile_fails() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QString, sentence);
    Loading loading;
    loading.loader->start(loading.file(name, content.toStdString()));
    QVERIFY(loading.waitForEnd());
    QCOMPARE(loading.failed.count(), 1);
    const QString told = loading.failed.at(0).at(0).toString();
    QVERIFY2(told.contains(sentence), qPrintable(told));
  }

  void programThatIsNotThere_fails() {
    Loading loading;
    loading.loader->setProgram("/nowhere/halfspace");
    loading.loader->start(loading.file("a.stl", "x"));
    QVERIFY(loading.waitForEnd());
    QCOMPARE(loading.failed.count(), 1);
    QVERIFY(loading.failed.at(0).at(0).toString().contains("cannot be started"));
  }

  void cancel_whileReading_tellsNothingMore() {
    Loading loading;
    loading.loader->start(loading.file("hang.stl", "x"));
    QVERIFY(QTest::qWaitFor([&] { return loading.progressed.count() > 0; }, longest));
    loading.loader->cancel();
    QCOMPARE(loading.cancelled.count(), 1);
    QVERIFY(!loading.loader->isLoading());
    loading.loader->cancel();
    QTest::qWait(200);
    QCOMPARE(loading.ends(), 1);
  }

  void cancel_whileALargeMeshArrives_leavesTheLoaderFree() {
    Loading loading;
    const QString large = loading.file("large.stl", manyTriangles(1'000'000));
    loading.loader->start(large);
    QVERIFY(QTest::qWaitFor([&] { return loading.progressed.count() > 2; }, longest));
    loading.loader->cancel();
    QCOMPARE(loading.cancelled.count(), 1);
    loading.loader->start(loading.file("a.stl", binaryStl(tetrahedronTriangles())));
    QVERIFY(QTest::qWaitFor([&] { return loading.loaded.count() > 0; }, longest));
    QCOMPARE(loading.loaded.at(0).at(0).value<LoadedMesh>().name, std::string("a"));
    QCOMPARE(loading.ends(), 2);
  }

  void readingThatTakesTooLong_isEnded() {
    Loading loading;
    loading.loader->setLongestReading(std::chrono::milliseconds(100));
    loading.loader->start(loading.file("hang.stl", "x"));
    QVERIFY(loading.waitForEnd());
    QCOMPARE(loading.failed.count(), 1);
    const QString told = loading.failed.at(0).at(0).toString();
    QVERIFY2(told.contains("takes too long"), qPrintable(told));
  }

  void start_whileLoading_cancelsTheOneBefore() {
    Loading loading;
    loading.loader->start(loading.file("hang.stl", "x"));
    loading.loader->start(loading.file("a.stl", binaryStl(tetrahedronTriangles())));
    QCOMPARE(loading.cancelled.count(), 1);
    QVERIFY(QTest::qWaitFor([&] { return loading.loaded.count() > 0; }, longest));
    QCOMPARE(loading.ends(), 2);
  }

  void destroying_endsWhatHangs() {
    Loading loading;
    loading.loader->start(loading.file("hang.stl", "x"));
    QVERIFY(QTest::qWaitFor([&] { return loading.progressed.count() > 0; }, longest));
    QElapsedTimer taken;
    taken.start();
    loading.loader.reset();
    QVERIFY(taken.elapsed() < longest / 2);
    QTest::qWait(50);
    QCOMPARE(loading.ends(), 0);
  }

  void destroying_atAnyMoment_doesNotCrash() {
    for (int i = 0; i < 20; ++i) {
      Loading loading;
      loading.loader->start(loading.file("a.stl", binaryStl(tetrahedronTriangles())));
      QTest::qWait(i);
    }
  }
};

QTEST_GUILESS_MAIN(MeshLoaderTest)
#include "mesh_loader_test.moc"
