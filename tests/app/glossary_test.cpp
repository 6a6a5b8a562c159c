// The glossary, from a key, from a term among the words, and back to the lesson that teaches it.
#include "tests/app/window_fixture.h"
#include "widgets/lesson/glossary_dialog.h"
#include "widgets/text/rich_label.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

namespace halfspace {
namespace {

GlossaryDialog *dialogOf(WindowFixture &fixture) { return fixture.window.findChild<GlossaryDialog *>(); }

QListWidget &termsOf(WindowFixture &fixture) { return *dialogOf(fixture)->findChild<QListWidget *>("terms"); }

QStringList seenIn(const QListWidget &list) {
  QStringList seen;
  for (int row = 0; row < list.count(); ++row)
    if (!list.item(row)->isHidden())
      seen << list.item(row)->text();
  return seen;
}

/// A place of a label's link to an address, and the label; null where none has it.
std::pair<RichLabel *, QPoint> linkTo(const QString &address, WindowFixture &fixture) {
  for (auto *label : fixture.window.findChildren<RichLabel *>())
    for (int y = 2; label->isVisible() && y < label->height(); y += 4)
      for (int x = 2; x < label->width(); x += 4)
        if (label->linkAt({x, y}) == address)
          return {label, {x, y}};
  return {nullptr, {}};
}

} // namespace

class GlossaryTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void key_opensIt_withAFigureOfTheTermThatIsChosen() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QVERIFY(!dialogOf(fixture));
    fixture.action(QKeySequence("Ctrl+G"))->trigger();
    QVERIFY(dialogOf(fixture)->isVisible());
    QVERIFY(termsOf(fixture).count() > 20);
    QVERIFY(termsOf(fixture).currentRow() >= 0);
    const auto *figure = dialogOf(fixture)->findChild<QLabel *>("termFigure");
    QVERIFY(!figure->pixmap(Qt::ReturnByValue).isNull());
  }

  void search_findsOtherFormsToo() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.action(QKeySequence("Ctrl+G"))->trigger();
    auto *search = dialogOf(fixture)->findChild<QLineEdit *>("termSearch");
    search->setText("feet");
    QCOMPARE(seenIn(termsOf(fixture)), QStringList{"foot"});
    QCOMPARE(termsOf(fixture).currentItem()->text(), QString("foot"));
    search->setText("no such term");
    QCOMPARE(seenIn(termsOf(fixture)), QStringList());
    QVERIFY(!dialogOf(fixture)->findChild<QPushButton *>("termLesson")->isEnabled());
    const auto *figure = dialogOf(fixture)->findChild<QLabel *>("termFigure");
    QVERIFY2(figure->pixmap(Qt::ReturnByValue).isNull(), "of the term before");
  }

  void search_choosesTheTermThatIsCalledSo() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.action(QKeySequence("Ctrl+G"))->trigger();
    dialogOf(fixture)->findChild<QLineEdit *>("termSearch")->setText("Normal");
    QVERIFY2(seenIn(termsOf(fixture)).indexOf("normal") > 0,
             "another term has the word, too, and stands before it");
    QCOMPARE(termsOf(fixture).currentItem()->text(), QString("normal"));
  }

  void chosenTerm_staysSo_inAnotherTheme_andWithAnotherLesson() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.action(QKeySequence("Ctrl+G"))->trigger();
    const auto picture = [&] {
      return dialogOf(fixture)->findChild<QLabel *>("termFigure")->pixmap(Qt::ReturnByValue).toImage();
    };
    termsOf(fixture).setCurrentRow(5);
    const QString term = termsOf(fixture).currentItem()->text();
    const QImage light = picture();
    fixture.window.look().chooseTheme("dark");
    QCOMPARE(termsOf(fixture).currentItem()->text(), term);
    QVERIFY(picture() != light);
    fixture.model().openLesson("plane-implicit");
    QCOMPARE(termsOf(fixture).currentItem()->text(), term);
  }

  void closedGlossary_isFilledWhenItIsOpenedAgain() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.action(QKeySequence("Ctrl+G"))->trigger();
    const int all = termsOf(fixture).count();
    dialogOf(fixture)->close();
    LessonLibrary fewer = fixture.model().library();
    fewer.lessons.resize(1);
    fixture.model().startWith(startOf(fewer.lessons.front()), fewer);
    fixture.window.look().chooseTheme("dark");
    fixture.action(QKeySequence("Ctrl+G"))->trigger();
    QVERIFY(termsOf(fixture).count() > 0 && termsOf(fixture).count() < all);
  }

  void termAmongTheWords_clicked_isLookedUp_andLeadsToItsStep() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.model().setStep(4);
    QTRY_VERIFY(linkTo("term:dot product", fixture).first); // once the words have their place
    const auto [label, place] = linkTo("term:dot product", fixture);
    QTest::mouseClick(label, Qt::LeftButton, {}, place);
    QVERIFY(dialogOf(fixture) && dialogOf(fixture)->isVisible());
    QCOMPARE(termsOf(fixture).currentItem()->text(), QString("dot product"));
    QTest::mouseClick(dialogOf(fixture)->findChild<QPushButton *>("termLesson"), Qt::LeftButton);
    QCOMPARE(fixture.model().session().lesson, std::string("dot-product-projection"));
    QCOMPARE(fixture.model().session().step, 0);
    QVERIFY(!linkTo("term:dot product", fixture).first); // here it is taught
  }
};

} // namespace halfspace

QTEST_MAIN(halfspace::GlossaryTest)
#include "glossary_test.moc"
