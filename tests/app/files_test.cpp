// What the window does with files: sessions and lessons that are opened and dropped, folders of lessons,
// settings and progress that cannot be read.
#include "app/application.h"
#include "app/export/export_window.h"
#include "app/export/figure_export.h"
#include "app/library/own_lesson_folders.h"
#include "app/standard_streams.h"
#include "app/work/handout_dialog.h"
#include "app/work/handout_export.h"
#include "app/work/known_file.h"
#include "lessons/scene/file/session_file.h"
#include "tests/app/box_answerer.h"
#include "tests/app/window_fixture.h"
#include "widgets/carriers/qr/qr_code.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QUrl>

#include <new>

using namespace halfspace;

namespace {

/// A lesson with one point, and what stands behind that in its scene.
QByteArray lessonText(const QByteArray &id, const QByteArray &entries = {}) {
  return "---\nid: " + id + "\ntitle: A lesson of my own, with a long title\nscene:\n" +
         "  - {name: Q, point: [1, 2, 3]}\n" + entries + "---\n## One\nWords.\n## Two\nMore words.\n";
}

void writeTo(const QString &file, const QByteArray &text) {
  QFile written(file);
  QVERIFY(written.open(QIODevice::WriteOnly));
  written.write(text);
}

QByteArray contentOf(const QString &file) {
  QFile read(file);
  return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
}

void drop(MainWindow &window, const QString &file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &enter); // else Qt does not know where the drop goes
  QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &event);
}

/// A menu as it is when it opens.
QMenu &opened(MainWindow &window, const char *name) {
  auto *menu = window.findChild<QMenu *>(name);
  emit menu->aboutToShow();
  return *menu;
}

QStringList textsOf(const QMenu &menu) {
  QStringList texts;
  for (const QAction *action : menu.actions())
    if (!action->isSeparator())
      texts << action->text();
  return texts;
}

QStringList tickedIn(const QMenu &menu) {
  QStringList texts;
  for (const QAction *action : menu.actions())
    if (action->isChecked())
      texts << action->text();
  return texts;
}

/// Throws when it is told to.
class Thrower : public QObject {
  void customEvent(QEvent *) override { throw std::bad_alloc(); }
};

} // namespace

class FilesTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void lesson_thatIsOpened_isShown_andReadAnewWhenItsFileGetsAnotherScene() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.md");
    writeTo(file, lessonText("mine"));
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.window.files().open(file);
    QCOMPARE(fixture.model().lesson().id, std::string("mine"));
    QCOMPARE(fixture.window.windowTitle(), QString("A lesson of my own, with a long title[*] — Halfspace"));
    fixture.scene().handles().select("Q");
    QTest::keyClick(&fixture.scene(), Qt::Key_PageUp);
    QVERIFY(isChanged(fixture.model()));
    writeTo(file, lessonText("mine", "  - {name: S, point: [0, 0, 0]}\n"));
    QTRY_COMPARE(fixture.model().session().scene.entries.size(), 2U);
    QVERIFY(!fixture.window.isWindowModified());
    QCOMPARE(fixture.window.windowTitle(), QString("A lesson of my own, with a long title[*] — Halfspace"));
  }

  void lesson_thatCannotBeRead_isRefusedWithTheReason_andTheSessionStays() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("broken.md");
    writeTo(file, "---\nid: broken\n---\n");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const BoxAnswerer box;
    fixture.window.files().open(file);
    QVERIFY2(box.text.contains("broken.md:2: title:"), qPrintable(box.text));
    QCOMPARE(fixture.model().lesson().id, std::string("signed-distance"));
  }

  void session_dropped_entersWhatIsTypedBeforeItAsks() {
    const QTemporaryDir folder;
    const QString other = folder.filePath("other.halfspace");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QVERIFY(fixture.window.files().saveTo(other));
    QVERIFY(fixture.window.files().saveTo(folder.filePath("mine.halfspace")));
    NumberField &field = *fixture.field("Q", 0);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, "3/7");
    const BoxAnswerer box; // which keeps the session
    drop(fixture.window, other);
    QTRY_VERIFY2(box.text.contains("mine.halfspace"), qPrintable(box.text));
    QVERIFY(fixture.value("Q").x == Rational(3, 7));
  }

  void picture_dropped_opensItsScene_andIsNoFileForSave() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("scene.PNG");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    fixture.window.findChild<FigureExport *>()->open();
    fixture.window.findChild<ExportWindow *>()->saveTo(file);
    QTRY_VERIFY(QFile::exists(file));
    WindowFixture other("ray-sphere");
    QVERIFY(other.ready);
    drop(other.window, file);
    QTRY_COMPARE(other.model().lesson().id, std::string("signed-distance"));
    QVERIFY(other.model().session() == before);
    QVERIFY(!other.window.files().file());
    QVERIFY(!other.window.files().hasChanges());
  }

  void photograph_ofACode_dropped_opensItsScene_andIsNoFileForSave() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("IMG_0001.JPG");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const auto code = qrCodeOf(writeSession(before));
    QVERIFY(code);
    const QSize paper = QSize(1, 1) * (code->side + 2 * quietModules);
    QImage picture(paper, QImage::Format_RGB32);
    picture.fill(Qt::white);
    for (int row = 0; row < code->side; ++row)
      for (int column = 0; column < code->side; ++column)
        if (code->isDark(column, row))
          picture.setPixelColor(column + quietModules, row + quietModules, Qt::black);
    QVERIFY(picture.scaled(6 * paper).save(file));
    WindowFixture other("ray-sphere");
    QVERIFY(other.ready);
    drop(other.window, file);
    QTRY_COMPARE(other.model().lesson().id, std::string("signed-distance"));
    QVERIFY(other.model().session() == before);
    QVERIFY(!other.window.files().file());
  }

  void handout_ofTheChosenSteps_saved_opensItsScene() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("handout.pdf");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Lesson &lesson = fixture.model().lesson();
    HandoutDialog dialog(lesson, 1, {}, &fixture.window);
    QCOMPARE(dialog.choices().steps, allStepsOf(lesson));
    dialog.findChild<QPushButton *>("thisStep")->click();
    QCOMPARE(dialog.choices().steps, std::vector<std::size_t>{1});
    dialog.findChild<QComboBox *>("columns")->setCurrentIndex(1);
    QCOMPARE(dialog.choices().columns, 2);
    auto &save = *dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Save);
    QVERIFY(save.isEnabled());
    const HandoutChoices choices = dialog.choices();
    dialog.findChild<QListWidget *>("steps")->item(1)->setCheckState(Qt::Unchecked);
    QVERIFY(!save.isEnabled()); // an empty one is for nobody

    const Session before = fixture.model().session();
    QVERIFY(fixture.window.findChild<HandoutExport *>()->saveTo(file, choices));
    WindowFixture other("ray-sphere");
    QVERIFY(other.ready);
    drop(other.window, file);
    QTRY_COMPARE(other.model().lesson().id, std::string("signed-distance"));
    QVERIFY(other.model().session().scene == before.scene);
    QCOMPARE(other.model().session().step, 1);
  }

  void handout_thatCannotBeWritten_saysWhy() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const BoxAnswerer box;
    QVERIFY(!fixture.window.findChild<HandoutExport *>()->saveTo("/nowhere/at/all.pdf", {{0}}));
    QTRY_VERIFY2(box.text.contains("/nowhere/at/all.pdf"), qPrintable(box.text));
  }

  void picture_withoutAScene_opened_saysSo_andLeavesTheSession() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("foreign.png");
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QVERIFY(picture.save(file));
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const BoxAnswerer box;
    fixture.window.files().open(file);
    QVERIFY2(box.text.contains("This picture holds no scene of Halfspace."), qPrintable(box.text));
    QVERIFY(fixture.model().session() == before);
  }

  void lesson_dropped_isOpened() {
    const QTemporaryDir folder;
    writeTo(folder.filePath("mine.md"), lessonText("mine"));
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    drop(fixture.window, folder.filePath("mine.md"));
    QTRY_COMPARE(fixture.model().lesson().id, std::string("mine"));
  }

  void foldersOfOwnLessons_areAListThatIsShownAndKept_andEachCanBeRemoved() {
    const QTemporaryDir first;
    const QTemporaryDir second;
    writeTo(first.filePath("one.md"), lessonText("one"));
    writeTo(second.filePath("two.md"), lessonText("two"));
    const QString removeFirst = "Remove " + first.path();
    const QString removeSecond = "Remove " + second.path();
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      fixture.window.findChild<OwnLessonFolders *>()->add(first.path());
      fixture.window.findChild<OwnLessonFolders *>()->add(second.path());
      QVERIFY(fixture.model().library().find("one") && fixture.model().library().find("two"));
      QVERIFY(fixture.window.close());
    }
    WindowFixture next("signed-distance");
    QVERIFY(next.ready);
    QCOMPARE(readSettings(settingsFile())->ownLessons, (QStringList{first.path(), second.path()}));
    QMenu &menu = opened(next.window, "ownLessons");
    QCOMPARE(textsOf(menu), (QStringList{"&Add a Folder…", removeFirst, removeSecond}));
    LessonLibrary library = next.model().library();
    addOwnLessons(library, first.path().toStdString());
    next.model().setLibrary(library);
    menu.actions().at(2)->trigger();
    QCOMPARE(textsOf(opened(next.window, "ownLessons")), (QStringList{"&Add a Folder…", removeSecond}));
    QVERIFY(!next.model().library().find("one"));
    QVERIFY(next.model().library().find("signed-distance"));
  }

  void snapping_chosen_isThereAndTickedAtTheNextStart_data() {
    QTest::addColumn<QString>("choice");
    for (const char *choice : {"Whole numbers", "Quarters", "Nothing (thousandths)"})
      QTest::newRow(choice) << choice;
  }

  void snapping_chosen_isThereAndTickedAtTheNextStart() {
    QFETCH(QString, choice);
    bool snapping = false;
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      for (QAction *action : opened(fixture.window, "snap").actions())
        if (action->text() == choice)
          action->trigger();
      snapping = fixture.model().snapping().isOn;
      QVERIFY(fixture.window.close());
    }
    WindowFixture next("signed-distance");
    QVERIFY(next.ready);
    QCOMPARE(tickedIn(opened(next.window, "snap")), QStringList{choice});
    QCOMPARE(next.model().snapping().isOn, snapping);
  }

  void themeAndSize_chosen_areStoredAtOnce_andNothingElseIs() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    Settings before = *readSettings(settingsFile());
    for (QAction *action : fixture.window.findChildren<QAction *>())
      if (action->text() == "Dark")
        action->trigger();
    fixture.window.findChild<QAction *>("larger")->trigger();
    const Settings stored = *readSettings(settingsFile());
    QCOMPARE(stored.theme, QString("dark"));
    QVERIFY(stored.sizeScale && *stored.sizeScale > 1);
    before.theme = stored.theme;
    before.sizeScale = stored.sizeScale;
    QVERIFY(stored == before);
    fixture.window.findChild<QAction *>("usualSize")->trigger();
    QVERIFY(!readSettings(settingsFile())->sizeScale);
  }

  void progressAndSettings_thatAreDamaged_arePutAsideAndTold() {
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      fixture.answer(0);
      QVERIFY(fixture.window.close());
    }
    QList<QByteArray> damaged;
    QStringList aside;
    for (const QString &file : {settingsFile(), progressFile()}) {
      damaged << contentOf(file).chopped(3);
      writeTo(file, damaged.last());
      aside << QString(file).replace(".json", "-damaged.json");
      QFile::remove(aside.last());
    }
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      const BoxAnswerer box;
      fixture.window.tellPutAside();
      for (const QString &file : aside)
        QVERIFY2(box.text.contains("put aside as " + QFileInfo(file).fileName()), qPrintable(box.text));
      fixture.answer(0);
      QVERIFY(fixture.window.close());
    }
    QVERIFY(readSettings(settingsFile()));
    const auto progress = readProgress(progressFile());
    QVERIFY(progress && std::any_of(progress->begin(), progress->end(),
                                    [](const auto &step) { return step.second.chosen.has_value(); }));
    for (int i = 0; i < aside.size(); ++i) {
      QCOMPARE(contentOf(aside[i]), damaged[i]);
      QVERIFY(QFile::remove(aside[i]));
    }
  }

  void pathOfAFile_thatNoTextCanTell_isNone() {
    QCOMPARE(absolutePathOf("/tmp/über.halfspace"), std::optional<QString>("/tmp/über.halfspace"));
    QCOMPARE(absolutePathOf("/tmp/\xE9t\xE9.halfspace"), std::optional<QString>());
  }

  void exception_outOfAnEvent_endsTheLoopAfterTheLastDeed() {
    auto &application = *static_cast<Application *>(qApp);
    int deeds = 0;
    application.setLastDeed([&] {
      ++deeds;
      throw std::bad_alloc(); // memory has not become more
    });
    Thrower thrower;
    QTimer::singleShot(0, &thrower, [&] {
      QCoreApplication::postEvent(&thrower, new QEvent(QEvent::User));
      QCoreApplication::postEvent(&thrower, new QEvent(QEvent::User));
    });
    QCOMPARE(QCoreApplication::exec(), exitRefused);
    QCOMPARE(deeds, 1);
  }
};

int main(int argc, char **argv) {
  Application application(argc, argv);
  FilesTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "files_test.moc"
