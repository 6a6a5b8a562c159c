// The export window: its choices and its preview, and figures and scenes on the clipboard.
#include "app/export/export_form.h"
#include "app/export/export_window.h"
#include "app/export/figure_export.h"
#include "app/export/preview_pane.h"
#include "lessons/scene/file/session_file.h"
#include "tests/app/box_answerer.h"
#include "tests/app/window_fixture.h"

#include <QApplication>
#include <QBuffer>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUrl>

using namespace halfspace;

namespace {

QByteArray contentOf(const QString &file) {
  QFile read(file);
  return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
}

/// As long as a figure may take on a machine that does much else, in milliseconds.
constexpr int patience = 20000;

/// A main window with its export window.
class ExportFixture : public WindowFixture {
public:
  explicit ExportFixture(const std::string &lesson) : WindowFixture(lesson) {
    window.findChild<FigureExport *>()->open();
    QSignalSpy previewed(&exports(), &ExportWindow::previewed);
    ready = ready && previewed.wait(patience);
  }

  ExportWindow &exports() { return *window.findChild<ExportWindow *>(); }
  template <class Field> Field &field(const char *name) { return *exports().findChild<Field *>(name); }

  /// Chooses the item of a combo box with a meaning.
  void choose(const char *name, const QVariant &meaning) {
    auto &combo = field<QComboBox>(name);
    combo.setCurrentIndex(combo.findData(meaning));
  }
  /// What a figure's file holds that is saved now.
  QByteArray saved(const QString &ending = ".png") {
    const QString file = m_folder.filePath("figure" + ending);
    QFile::remove(file);
    exports().saveTo(file);
    return QTest::qWaitFor([&] { return QFile::exists(file); }, patience) ? contentOf(file) : QByteArray();
  }
  QString message() { return field<QLabel>("exportMessage").text(); }

private:
  QTemporaryDir m_folder;
};

/// A PNG file of a picture's pixels, without what else its file held.
QByteArray pixelsAlone(const QImage &picture) {
  QImage pixels(picture.size(), QImage::Format_RGB32);
  QPainter painter(&pixels);
  painter.drawImage(0, 0, picture);
  painter.end();
  QBuffer file;
  return file.open(QIODevice::WriteOnly) && pixels.save(&file, "PNG") ? file.data() : QByteArray();
}

void moveIn(QWidget &widget, const QPoint &to, Qt::MouseButtons buttons) {
  QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, buttons, {});
  QCoreApplication::sendEvent(&widget, &move);
}

/// A place on the page of a preview at which there is a label that can be taken.
std::optional<QPoint> labelIn(QWidget &page) {
  constexpr int stride = 4;
  for (int y = 0; y < page.height(); y += stride)
    for (int x = 0; x < page.width(); x += stride) {
      moveIn(page, {x, y}, Qt::NoButton);
      if (page.cursor().shape() == Qt::OpenHandCursor)
        return QPoint(x, y);
    }
  return {};
}

/// The clipboard as it lies there, for another to put there again.
std::unique_ptr<QMimeData> onlyOf(const char *type) {
  auto data = std::make_unique<QMimeData>();
  data->setData(type, QApplication::clipboard()->mimeData()->data(type));
  return data;
}

} // namespace

class ExportTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("halfspace-test");
    QCoreApplication::setApplicationName("export");
  }
  void init() { forgetStarts(); }

  void png_isAsWideAsChosen_onPaperAndInPixels_andFramedAsTheScreen() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.field<QDoubleSpinBox>("width").setValue(8);
    const QImage onPaper = QImage::fromData(fixture.saved());
    QCOMPARE(onPaper.width(), 945);
    QVERIFY(std::abs(onPaper.dotsPerMeterX() * 0.0254 - 300) < 0.1);
    const PixelSize screen = fixture.scene().screen().size();
    QVERIFY(std::abs(onPaper.height() - 945.0 * screen.height / screen.width) <= 1);
    fixture.choose("measure", false);
    fixture.field<QSpinBox>("pixelsAcross").setValue(600);
    QCOMPARE(QImage::fromData(fixture.saved()).width(), 600);
  }

  void pictureInPixels_asWideAsTheScreen_isThePictureOfTheScreen() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.exports().close();
    QTRY_VERIFY(!fixture.window.findChild<ExportWindow *>());
    const QImage screen = fixture.scene().grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    fixture.window.findChild<FigureExport *>()->open();
    fixture.choose("measure", false);
    fixture.field<QSpinBox>("pixelsAcross").setValue(screen.width());
    const QImage figure = QImage::fromData(fixture.saved()).convertToFormat(QImage::Format_RGB32);
    QCOMPARE(figure.size(), screen.size());
    int different = 0;
    constexpr int muchDifferent = 48;
    for (int y = 0; y < figure.height(); ++y)
      for (int x = 0; x < figure.width(); ++x)
        different += std::abs(qGray(figure.pixel(x, y)) - qGray(screen.pixel(x, y))) > muchDifferent;
    QVERIFY2(different < figure.width() * figure.height() / 100, qPrintable(QString::number(different)));
  }

  void choices_ofTheLook_changeWhatTheFileShows() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const std::tuple<const char *, QVariant, const char *> combos[] = {
        {"framing", true, ".png"},
        {"theme", "print", ".png"},
        {"hidden", static_cast<int>(HiddenLines::LeftOut), ".svg"},
        {"text", static_cast<int>(TextAs::Letters), ".svg"}};
    for (const auto &[name, meaning, ending] : combos) {
      const QByteArray before = fixture.saved(ending);
      fixture.choose(name, meaning);
      const QByteArray after = fixture.saved(ending);
      QVERIFY2(!before.isEmpty() && !after.isEmpty() && before != after, name);
    }
    fixture.field<QCheckBox>("transparent").click();
    QCOMPARE(QImage::fromData(fixture.saved(".png")).pixelColor(0, 0).alpha(), 0);
    fixture.field<QCheckBox>("session").click();
    for (const char *ending : {".png", ".svg", ".pdf"})
      QVERIFY2(!findSessionIn(fixture.saved(ending).toStdString(), ""), ending);
  }

  void file_carriesTheSession_asItIsOnTheScreen() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    for (const char *ending : {".png", ".svg", ".pdf"}) {
      const auto found = findSessionIn(fixture.saved(ending).toStdString(), "");
      QVERIFY2(found, ending);
      QCOMPARE(found->text, writeSession(fixture.model().session()));
    }
    const QByteArray latex = fixture.saved(".tex");
    QVERIFY(latex.contains("tikzpicture"));
  }

  void fields_withoutUseForTheFormat_areDisabled() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const auto enabled = [&] {
      QStringList names;
      for (const char *name : {"measure", "pixelsPerInch", "pixelsAcross", "hidden", "text", "session"})
        if (fixture.field<QWidget>(name).isEnabled())
          names << name;
      return names;
    };
    QCOMPARE(enabled(), (QStringList{"measure", "pixelsPerInch", "session"}));
    fixture.choose("measure", false);
    QCOMPARE(enabled(), (QStringList{"measure", "pixelsAcross", "session"}));
    fixture.choose("format", ".svg");
    QCOMPARE(enabled(), (QStringList{"hidden", "text", "session"}));
    fixture.choose("format", ".pdf");
    QCOMPARE(enabled(), (QStringList{"hidden", "session"}));
    fixture.choose("format", ".tex");
    QCOMPARE(enabled(), QStringList{"hidden"});
    QVERIFY(!fixture.field<QCheckBox>("flat").isVisible());
  }

  void flatPicture_isOfferedWhereTheLessonHasOne_andDrawnInstead() {
    ExportFixture fixture("reflection");
    QVERIFY(fixture.ready);
    const QByteArray inSpace = fixture.saved(".svg");
    QVERIFY(fixture.field<QComboBox>("hidden").isEnabled());
    fixture.field<QCheckBox>("flat").click();
    QVERIFY(!fixture.field<QComboBox>("hidden").isEnabled()); // there nothing is hidden
    const QByteArray flat = fixture.saved(".svg");
    QVERIFY(!flat.isEmpty() && flat != inSpace);
    QVERIFY(!flat.contains("class=\"hidden\""));
  }

  void code_besideTheFigure_isInTheFileAndThePreview_andReadFromItsPixels() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const QImage without = QImage::fromData(fixture.saved());
    auto &pane = *fixture.exports().findChild<PreviewPane *>();
    const QSize before = pane.widget()->sizeHint();
    QSignalSpy previewed(&fixture.exports(), &ExportWindow::previewed);
    fixture.field<QCheckBox>("code").click();
    QVERIFY(previewed.wait(patience));
    const QSize after = pane.widget()->sizeHint();
    const QImage with = QImage::fromData(fixture.saved());
    QVERIFY(with.width() > without.width());
    QVERIFY(double(after.width()) / after.height() > double(before.width()) / before.height());
    const auto found = findSessionIn(pixelsAlone(with).toStdString(), "");
    QVERIFY2(found, found ? "" : found.problem().sentence.c_str());
    QCOMPARE(found->text, writeSession(fixture.model().session()));
    fixture.field<QCheckBox>("session").click();
    QVERIFY(!fixture.field<QCheckBox>("code").isEnabled());
    QCOMPARE(QImage::fromData(fixture.saved()).width(), without.width());
    fixture.choose("format", ".tex"); // which carries no scene that could be left out
    QVERIFY(fixture.field<QCheckBox>("code").isEnabled());
    const QByteArray withCode = fixture.saved(".tex");
    fixture.field<QCheckBox>("code").click();
    QVERIFY(withCode.size() > fixture.saved(".tex").size());
  }

  void parts_thatAreLeftOut_areNotInTheFile() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QByteArray before = fixture.saved(".svg");
    // While the step's question is open no coordinates are written, whatever is chosen.
    for (const char *part : {"drop-lines", "labels", "axes", "grid", "shadows"}) {
      fixture.field<QCheckBox>(part).click();
      const QByteArray after = fixture.saved(".svg");
      QVERIFY2(!after.isEmpty() && after != before, part);
      before = after;
    }
    QVERIFY(!fixture.field<QCheckBox>("coordinates").isEnabled()); // they stand in labels
  }

  void label_draggedInThePreview_staysThere_inTheSceneAndItsFile_untilItIsUndone() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Scene before = fixture.model().session().scene;
    QWidget &page = *fixture.exports().findChild<PreviewPane *>()->widget();
    const auto label = labelIn(page);
    QVERIFY(label);
    QTest::mousePress(&page, Qt::LeftButton, {}, *label);
    moveIn(page, *label + QPoint(40, 30), Qt::LeftButton);
    QTest::mouseRelease(&page, Qt::LeftButton, {}, *label + QPoint(40, 30));
    const Session moved = fixture.model().session();
    QCOMPARE(moved.scene.labels.size(), 1U);
    QVERIFY(moved.scene.labels.begin()->second.spot);
    const auto carried = findSessionIn(fixture.saved(".svg").toStdString(), "");
    QVERIFY(carried && carried->session == moved);
    fixture.exports().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.exports()));
    QTest::keyClick(&fixture.exports(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(fixture.model().session().scene == before);
    QTest::keyClick(&fixture.exports(), Qt::Key_Z, Qt::ControlModifier); // there is nothing more to undo
    QVERIFY(fixture.model().session().scene == before);
    QTest::keyClick(&fixture.exports(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(fixture.model().session() == moved);
    QTest::keyClick(&fixture.exports(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(fixture.model().session() == moved);
  }

  void label_thatIsHeld_goesBackWithEscape_andTheWindowStays() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Scene before = fixture.model().session().scene;
    QWidget &page = *fixture.exports().findChild<PreviewPane *>()->widget();
    const auto label = labelIn(page);
    QVERIFY(label);
    QTest::mousePress(&page, Qt::LeftButton, {}, *label);
    moveIn(page, *label + QPoint(40, 30), Qt::LeftButton);
    QVERIFY(fixture.model().session().scene != before);
    QTest::keyClick(&fixture.exports(), Qt::Key_Escape);
    QVERIFY(fixture.model().session().scene == before);
    QVERIFY(fixture.exports().isVisible());
    QTest::mouseRelease(&page, Qt::LeftButton, {}, *label + QPoint(40, 30));
    QTest::keyClick(&fixture.exports(), Qt::Key_Escape);
    QVERIFY(!fixture.exports().isVisible());
  }

  void label_takenAndDeleted_isHidden_andComesBackByTheMenu() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    auto &pane = *fixture.exports().findChild<PreviewPane *>();
    const auto label = labelIn(*pane.widget());
    QVERIFY(label);
    QTest::mouseClick(pane.widget(), Qt::LeftButton, {}, *label);
    QTest::keyClick(&pane, Qt::Key_Delete);
    const LabelsByHand &labels = fixture.model().session().scene.labels;
    QVERIFY(labels.size() == 1 && labels.begin()->second.isHidden);
    QMenu &menu = *fixture.field<QToolButton>("labelsMenu").menu();
    emit menu.aboutToShow();
    menu.actions().last()->trigger();
    QVERIFY(fixture.model().session().scene.labels.empty());
    emit menu.aboutToShow();
    menu.actions().first()->trigger();
    QVERIFY(fixture.model().session().scene.labels.begin()->second.isHidden);
  }

  void preview_followsEachChoice_soon() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    for (const char *ending : {".svg", ".png"}) {
      fixture.choose("format", ending);
      QSignalSpy previewed(&fixture.exports(), &ExportWindow::previewed);
      QVERIFY(previewed.wait(patience) || previewed.count());
      const QImage before = fixture.exports().findChild<PreviewPane *>()->grab().toImage();
      previewed.clear();
      QElapsedTimer timer;
      timer.start();
      fixture.choose("theme", QString(ending) == ".svg" ? "dark" : "light");
      QVERIFY(previewed.wait(patience));
      qInfo("%s: %lld ms", ending, timer.elapsed());
      QVERIFY(fixture.exports().findChild<PreviewPane *>()->grab().toImage() != before);
    }
  }

  void size_isTold_andThatOfTheFileSoonAfter() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.field<QDoubleSpinBox>("width").setValue(8);
    auto &size = fixture.field<QLabel>("figureSize");
    QTRY_VERIFY2(size.text().startsWith("8 × ") && size.text().contains("945 × "), qPrintable(size.text()));
    QTRY_VERIFY2(size.text().endsWith(" KB"), qPrintable(size.text()));
    const QString told = size.text();
    const double bytes = fixture.saved().size();
    QVERIFY2(std::abs(told.section(", ", -1).section(' ', 0, 0).toDouble() * 1000 - bytes) < bytes / 10,
             qPrintable(told));
  }

  void choices_areThereTheNextTime_andAtTheNextStart() {
    {
      ExportFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      fixture.choose("format", ".pdf");
      fixture.field<QDoubleSpinBox>("width").setValue(7.5);
      fixture.choose("theme", "print");
      QTest::keyClick(&fixture.exports(), Qt::Key_Escape);
      QTRY_VERIFY(!fixture.window.findChild<ExportWindow *>());
      fixture.window.findChild<FigureExport *>()->open();
      QCOMPARE(fixture.exports().choices().ending, std::string(".pdf"));
    }
    ExportFixture next("signed-distance");
    QVERIFY(next.ready);
    QCOMPARE(next.field<QDoubleSpinBox>("width").value(), 7.5);
    QCOMPARE(next.field<QComboBox>("theme").currentData().toString(), QString("print"));
    QCOMPARE(next.exports().choices().ending, std::string(".pdf"));
  }

  void folderOfTheLastFigure_isKept() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const QTemporaryDir folder;
    fixture.exports().saveTo(folder.filePath("a.svg"));
    QTRY_COMPARE(readSettings(settingsFile())->figureFolder, folder.path());
    QCOMPARE(readSettings(settingsFile())->figure.ending, std::string(".svg"));
  }

  void figureThatCannotBeWritten_isSaidInTheWindow_andLeavesNothing() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.exports().saveTo("/nowhere/at/all.png");
    QTRY_VERIFY2(fixture.message().contains("/nowhere/at/all.png"), qPrintable(fixture.message()));
    QVERIFY(!QFile::exists("/nowhere"));
    const QTemporaryDir folder;
    fixture.exports().saveTo(folder.filePath("figure.doc"));
    QVERIFY2(fixture.message().contains("figure.doc"), qPrintable(fixture.message()));
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void figureOfTooManyPixels_isRefusedAtOnce() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.field<QDoubleSpinBox>("width").setValue(100);
    fixture.field<QSpinBox>("pixelsPerInch").setValue(2400);
    QTRY_VERIFY2(fixture.message().contains("16384"), qPrintable(fixture.message()));
  }

  void copy_bringsPictureVectorsSourceAndScene() {
    ExportFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QApplication::clipboard()->clear();
    QTest::mouseClick(&fixture.field<QPushButton>("copyFigure"), Qt::LeftButton);
    QTRY_VERIFY(QApplication::clipboard()->mimeData()->hasImage());
    const QMimeData &copied = *QApplication::clipboard()->mimeData();
    const std::string session = writeSession(fixture.model().session());
    QCOMPARE(copied.data(sessionMimeType).toStdString(), session);
    QCOMPARE(findSessionIn(copied.data("image/png").toStdString(), "")->text, session);
    QCOMPARE(findSessionIn(copied.data("image/svg+xml").toStdString(), "")->text, session);
    QVERIFY(copied.text().contains("\\begin{tikzpicture}"));
    QVERIFY2(copied.html().startsWith("<img width=\"453\" "),
             qPrintable(copied.html().left(80))); // 12 cm, in whole pixels at 300 an inch
  }

  void copiedPicture_pastedFromEachForm_bringsTheScene() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.scene().handles().select("Q");
    QTest::keyClick(&fixture.scene(), Qt::Key_PageUp);
    const Session before = fixture.model().session();
    fixture.action(QKeySequence("Ctrl+Shift+C"))->trigger();
    const auto pasted = [&](const char *type) {
      QApplication::clipboard()->setMimeData(onlyOf(type).release());
      WindowFixture other("ray-sphere");
      other.action(QKeySequence::Paste)->trigger();
      return other.model().session() == before;
    };
    std::vector<std::unique_ptr<QMimeData>> forms;
    for (const char *type : {sessionMimeType, "image/png", "image/svg+xml"})
      forms.push_back(onlyOf(type));
    for (auto &form : forms) {
      const QString type = form->formats().first();
      QApplication::clipboard()->setMimeData(form.release());
      QVERIFY2(pasted(type.toUtf8()), qPrintable(type));
    }
  }

  void keyOfPaste_inAField_pastesWords_andElsewhereTheScene() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    auto words = std::make_unique<QMimeData>();
    words->setText("3/7");
    words->setData(sessionMimeType, QByteArray::fromStdString(writeSession(
                                        startOf(*fixture.model().library().find("ray-sphere")))));
    QApplication::clipboard()->setMimeData(words.release());
    NumberField &field = *fixture.field("Q", 0);
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(field.text(), QString("3/7"));
    QCOMPARE(fixture.model().session().lesson, std::string("signed-distance"));
    field.drop();
    fixture.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
    fixture.scene().setFocus();
    QTest::keyClick(&fixture.scene(), Qt::Key_V, Qt::ControlModifier);
    QTRY_COMPARE(fixture.model().session().lesson, std::string("ray-sphere"));
  }

  void paste_asksBeforeChangesAreLost() {
    const QTemporaryDir folder;
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.action(QKeySequence("Ctrl+Shift+C"))->trigger();
    QVERIFY(fixture.window.files().saveTo(folder.filePath("mine.halfspace")));
    fixture.scene().handles().select("Q");
    QTest::keyClick(&fixture.scene(), Qt::Key_PageUp);
    const Session changed = fixture.model().session();
    {
      const BoxAnswerer no("Cancel");
      fixture.action(QKeySequence::Paste)->trigger();
      QVERIFY(!no.text.isEmpty());
    }
    QVERIFY(fixture.model().session() == changed);
    const BoxAnswerer discard("Discard");
    fixture.action(QKeySequence::Paste)->trigger();
    QVERIFY(!discard.text.isEmpty());
    QVERIFY(!(fixture.model().session() == changed));
    QVERIFY(!fixture.window.files().file());
  }

  void paste_withoutAScene_saysSo_andChangesNothing() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const auto says = [&](const QString &words) {
      fixture.action(QKeySequence::Paste)->trigger();
      return fixture.window.findChild<QLabel *>("message")->text() == words;
    };
    QApplication::clipboard()->setText("words");
    QVERIFY(says("There is no scene on the clipboard."));
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(Qt::white);
    auto foreign = std::make_unique<QMimeData>();
    foreign->setData("image/png", pixelsAlone(picture));
    QApplication::clipboard()->setMimeData(foreign.release());
    QVERIFY(says("This picture holds no scene of Halfspace."));
    auto broken = std::make_unique<QMimeData>();
    broken->setData(sessionMimeType, "{\"format\":\"halfspace\"");
    QApplication::clipboard()->setMimeData(broken.release());
    fixture.action(QKeySequence::Paste)->trigger();
    QVERIFY(fixture.model().session() == before);
  }
};

QTEST_MAIN(ExportTest)
#include "export_test.moc"
