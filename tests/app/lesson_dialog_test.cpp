// A lesson that is made of a scene in Explore, in a real window: written, checked, saved, opened, worked
// through.
#include "app/check.h"
#include "app/explore/lesson_dialog.h"
#include "app/work/session_files.h"
#include "lessons/object/kinds/point.h"
#include "tests/app/window_fixture.h"
#include "widgets/explore/entry_field.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>

#include <functional>

using namespace halfspace;

namespace {

/// Somebody with the dialog open: sees what it says, types and clicks.
class Author {
public:
  explicit Author(LessonDialog &dialog) : m_dialog(dialog) {}

  template <class Widget> Widget &part(const QString &name) {
    auto *found = m_dialog.findChild<Widget *>(name);
    if (!found)
      qFatal("no %s", qPrintable(name));
    return *found;
  }
  QString complaint() { return part<QLabel>("complaint").text(); }
  bool maySave() { return part<QPushButton>("saveLesson").isEnabled(); }
  void click(const QString &button) { QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton); }
  void openTab(int tab) {
    auto *bar = part<QTabWidget>("stepTabs").tabBar();
    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(tab).center());
  }
  void type(const QString &field, const QString &text) {
    auto &widget = part<QWidget>(field);
    widget.setFocus();
    QTest::keyClick(&widget, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&widget, text);
  }
  void choose(const QString &combo, const QString &text) {
    auto &box = part<QComboBox>(combo);
    box.setFocus();
    while (box.currentText() != text && box.currentIndex() + 1 < box.count())
      QTest::keyClick(&box, Qt::Key_Down);
  }
  void tick(const QString &list, int row) {
    auto *items = part<QWidget>(list).findChild<QListWidget *>();
    items->setFocus();
    items->setCurrentRow(row);
    QTest::keyClick(items, Qt::Key_Space);
  }
  /// On the box in the heading of a group.
  void tickGroup(const QString &group) {
    auto &box = part<QGroupBox>(group);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Space);
  }

private:
  LessonDialog &m_dialog;
};

/// Answers what the program asks one after the other, as long as it lives: the lesson's dialog by doing
/// something in it, the file's by a file, a question by a button.
class DialogAnswerer : public QObject {
public:
  DialogAnswerer(std::function<void(Author &)> write, QString file, QStringList buttons)
      : m_write(std::move(write)), m_file(std::move(file)), m_buttons(std::move(buttons)) {
    connect(&m_timer, &QTimer::timeout, this, &DialogAnswerer::answer);
    m_timer.start(30);
  }

  [[nodiscard]] bool isDone() const { return !m_write && m_buttons.isEmpty(); }

private:
  void answer() {
    QWidget *asks = QApplication::activeModalWidget();
    if (auto *lesson = qobject_cast<LessonDialog *>(asks); lesson && m_write) {
      QTimer::singleShot(0, lesson, [lesson, write = std::exchange(m_write, nullptr)] {
        Author author(*lesson);
        write(author); // what it asks for in its turn is answered meanwhile
        if (lesson->isVisible())
          lesson->reject();
      });
    } else if (auto *file = qobject_cast<QFileDialog *>(asks)) {
      file->findChild<QLineEdit *>()->setText(m_file);
      QMetaObject::invokeMethod(file, "accept", Qt::QueuedConnection); // it may ask in its turn
    } else if (auto *box = qobject_cast<QMessageBox *>(asks); box && !m_buttons.isEmpty()) {
      const QString wanted = m_buttons.takeFirst();
      for (QAbstractButton *button : box->buttons())
        if (button->text().remove('&') == wanted)
          return button->click();
      box->reject();
    }
  }

  std::function<void(Author &)> m_write;
  QString m_file;
  QStringList m_buttons;
  QTimer m_timer;
};

class AuthorFixture : public WindowFixture {
public:
  AuthorFixture() : WindowFixture("explore") {}

  QAction &item() { return *window.findChild<QAction *>("saveAsLesson"); }
  void enter(const QString &line) {
    auto *field = window.findChild<EntryField *>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, line);
    QTest::keyClick(field, Qt::Key_Return);
  }
  void buildScene() {
    for (const char *line : {"Q = (11, 15, 8)", "E: x + 2y + 2z = 27", "d = distance(Q, E)"})
      enter(line);
  }
  /// Where a lesson can be saved.
  QString file() const { return m_folder.filePath("sides.md"); }

private:
  QTemporaryDir m_folder;
};

constexpr int shownTab = 1;
constexpr int questionTab = 2;
constexpr int taskTab = 3;

void writeQuestion(Author &author) {
  author.openTab(questionTab);
  author.tickGroup("question");
  author.type("ask", "On which side of E is Q?");
  author.choose("decides", "side");
  author.type("answer-positive", "Where $\\vec n$ points to");
  author.type("answer-negative", "On the other side: 'below'");
  author.type("why", "The sign tells.");
}

void writeTask(Author &author) {
  author.openTab(taskTab);
  author.tickGroup("task");
  author.type("instruction", "Drag Q to the other side.");
  author.type("condition", "side = negative");
}

} // namespace

class LessonDialogTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void item_isThere_whileExploreHasAScene() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    QVERIFY(!fixture.item().isEnabled());
    fixture.enter("Q = (1, 2, 3)");
    QVERIFY(fixture.item().isEnabled());
    fixture.model().openLesson("signed-distance");
    QVERIFY(!fixture.item().isEnabled());
  }

  void lesson_writtenWithKeysAndMouse_isSaved_checked_opened_andWorks() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    fixture.buildScene();
    const Scene scene = fixture.model().session().scene;
    DialogAnswerer asked(
        [](Author &author) {
          QVERIFY(!author.maySave());
          author.type("title", "Sides: two of them");
          author.type("words", "Look at $f(Q)$ = ");
          auto &values = author.part<QComboBox>("wordsValues");
          emit values.activated(values.findText("f = 30"));
          QTest::keyClicks(&author.part<QPlainTextEdit>("words"), ".");
          QCOMPARE(author.part<QPlainTextEdit>("words").toPlainText(), QString("Look at $f(Q)$ = {f}."));
          writeQuestion(author);
          QCOMPARE(author.complaint(), QString());
          author.click("addStep");
          author.type("stepTitle", "Do it");
          author.openTab(shownTab);
          author.tick("hidden", 1);
          author.tick("hidden", 2);
          writeTask(author);
          QCOMPARE(author.complaint(), QString());
          author.click("saveLesson");
        },
        fixture.file(), {"Open"});
    fixture.item().trigger();
    QVERIFY(asked.isDone());

    const Checked checked = checkLessons({fixture.file().toStdString()}, readLessons(TEST_LESSONS_FOLDER));
    QCOMPARE(checked.lessons, std::size_t(1));
    QVERIFY2(checked.problems.empty(),
             checked.problems.empty() ? "" : checked.problems.front().text().c_str());
    QCOMPARE(fixture.model().lesson().id, std::string("sides-two-of-them"));
    QCOMPARE(fixture.model().lesson().title, std::string("Sides: two of them"));
    QVERIFY(fixture.model().session().scene == scene);

    QVERIFY(fixture.questionIsOpen());
    QVERIFY(!findMark(fixture.model().shown().figure, "d.F"));
    fixture.answer(0);
    QVERIFY(!fixture.questionIsOpen());
    QVERIFY(findMark(fixture.model().shown().figure, "d.F"));
    QVERIFY(!fixture.model().shown().working.lines.empty());

    fixture.model().setStep(1);
    QVERIFY(findMark(fixture.model().shown().figure, "Q"));
    QVERIFY2(!findMark(fixture.model().shown().figure, "E"), "it is hidden");
    QVERIFY2(!findMark(fixture.model().shown().figure, "d.F"), "it is hidden");
    const std::vector<Handle> &handles = fixture.scene().handles().selection().handles();
    QVERIFY(!handles.empty());
    QVERIFY2(std::none_of(handles.begin(), handles.end(),
                          [](const Handle &handle) { return handle.object == "E"; }),
             "what nobody sees is not taken");
    const Task task = tasksOf(fixture.model().step()).front();
    QVERIFY(!isDone(task, fixture.model().evaluation()));
    fixture.model().history().editTogether({ChangeObject{"Q", Object(PointObject{{0, 0, 0}})}}, "Move Q");
    QVERIFY(isDone(task, fixture.model().evaluation()));
  }

  void lessonThatWasMadeSo_isMadeAnew_whereItIsOpen_andFromExplore() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    fixture.buildScene();
    const Scene scene = fixture.model().session().scene;
    const auto writes = [&](const QString &title, const QString &words, const QStringList &buttons) {
      DialogAnswerer asked(
          [=](Author &author) {
            author.type("title", title);
            author.type("words", words);
            author.click("saveLesson");
          },
          fixture.file(), buttons);
      fixture.item().trigger();
      return asked.isDone();
    };
    QVERIFY(writes("Sides", "One.", {"Open"}));
    QCOMPARE(fixture.model().lesson().id, std::string("sides"));
    QCOMPARE(fixture.model().lesson().chapter, std::string("Own lessons"));
    fixture.model().openLesson(exploreId);
    QVERIFY2(fixture.model().session().scene == scene, "it was not asked about, as it stays");

    fixture.model().openLesson("sides");
    QVERIFY(fixture.item().isEnabled());
    fixture.model().history().editTogether({ChangeObject{"Q", Object(PointObject{{0, 0, 0}})}}, "Move Q");
    QVERIFY(writes("Sides of a plane", "Two.", {}));
    const auto wordsOf = [&] {
      return std::get<StepWords>(fixture.model().lesson().steps.front().blocks.front()).text.written();
    };
    QCOMPARE(fixture.model().lesson().id, std::string("sides"));
    QCOMPARE(fixture.model().lesson().title, std::string("Sides of a plane"));
    QCOMPARE(wordsOf(), std::string("Two."));
    QVERIFY2(fixture.model().lesson().scene == scene, "the lesson begins as it began");

    {
      DialogAnswerer asked([](Author &author) { author.type("words", "Two and a half."); }, {}, {});
      fixture.item().trigger();
      QVERIFY(asked.isDone());
      QVERIFY2(hasUnsaved(fixture.window.files().lessonWorks()), "it is kept until somebody wants it");
      DialogAnswerer back([](Author &author) { author.type("words", "Two."); }, {}, {});
      fixture.item().trigger();
      QVERIFY(back.isDone());
    }
    {
      DialogAnswerer asked([](Author &author) { author.click("discardLesson"); }, {}, {"Discard"});
      fixture.item().trigger();
      QVERIFY(asked.isDone());
      QVERIFY(!hasUnsaved(fixture.window.files().lessonWorks()));
      QCOMPARE(wordsOf(), std::string("Two."));
    }
    fixture.window.findChild<QAction *>("goOnInExplore")->trigger();
    fixture.enter("R = (0, 0, 0)");
    QVERIFY(writes("Sides of a plane", "Three.", {"Yes", "Open"}));
    QCOMPARE(fixture.model().lesson().id, std::string("sides"));
    QCOMPARE(wordsOf(), std::string("Three."));
    QVERIFY(fixture.model().lesson().scene.entries.find("R"));
    QCOMPARE(fixture.model().library().lessons.size(), readLessons(TEST_LESSONS_FOLDER).lessons.size() + 1);
  }

  void whatIsWritten_andNotSaved_isKept_andGoesWithItsSceneAlone() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    fixture.buildScene();
    DialogAnswerer first([](Author &author) { author.type("title", "Half of it"); }, {}, {});
    fixture.item().trigger();
    QVERIFY(first.isDone());
    SessionFiles &files = fixture.window.files();
    QVERIFY(hasUnsaved(files.lessonWorks()));
    QCOMPARE(files.lessonWorks().at(exploreId).draft.title, std::string("Half of it"));
    {
      DialogAnswerer asked({}, {}, {"Discard", "Cancel"});
      files.startNew();
      QVERIFY2(asked.isDone(), "the scene may go, but not what is written of it");
    }
    QVERIFY(!fixture.model().session().scene.entries.empty());
    {
      DialogAnswerer asked({}, {}, {"Discard", "Discard"});
      files.startNew();
      QVERIFY(asked.isDone());
    }
    QVERIFY(fixture.model().session().scene.entries.empty());
    QVERIFY(files.lessonWorks().empty());
    fixture.enter("A = (1, 2, 3)");
    DialogAnswerer second([](Author &author) { QCOMPARE(author.part<QLineEdit>("title").text(), QString()); },
                          {}, {});
    fixture.item().trigger();
    QVERIFY(second.isDone());
  }

  void whatIsWrong_isSaidWithItsStep_andKeepsTheLessonFromBeingSaved() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    fixture.buildScene();
    DialogAnswerer asked(
        [](Author &author) {
          QCOMPARE(author.complaint(), QString("The lesson has no title."));
          author.type("title", "Sides");
          QVERIFY(author.maySave());
          author.type("words", "It is {g}.");
          QVERIFY2(author.complaint().startsWith("Step 1: There is no value “g”."),
                   qPrintable(author.complaint()));
          QVERIFY(!author.maySave());
          author.type("words", "It is $\\frac{1}$.");
          QVERIFY2(author.complaint().contains("column"), qPrintable(author.complaint()));
          author.type("words", "## Another");
          QVERIFY2(author.complaint().contains("begins a step"), qPrintable(author.complaint()));
          author.type("words", "It is {f}.");
          writeQuestion(author);
          author.type("answer-positive", " ");
          QVERIFY2(author.complaint().contains("at least two choices"), qPrintable(author.complaint()));
          author.type("answer-on", "In it");
          QVERIFY2(author.complaint().contains("At the start “side” is “positive”"),
                   qPrintable(author.complaint()));
        },
        {}, {});
    fixture.item().trigger();
    QVERIFY(asked.isDone());
  }

  void conditionOfATask_isToldWhetherItHoldsNow() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    fixture.buildScene();
    DialogAnswerer asked(
        [](Author &author) {
          author.type("title", "Sides");
          writeTask(author);
          auto &now = author.part<QLabel>("conditionNow");
          QVERIFY2(now.text().contains("does not hold"), qPrintable(now.text()));
          QVERIFY(!now.property("wrong").toBool());
          author.type("condition", "side = positive");
          QVERIFY2(now.text().contains("holds already"), qPrintable(now.text()));
          QVERIFY(now.property("wrong").toBool());
          author.type("condition", "side = upper");
          QVERIFY2(author.complaint().contains("never “upper”"), qPrintable(author.complaint()));
        },
        {}, {});
    fixture.item().trigger();
    QVERIFY(asked.isDone());
  }

  void draft_staysForTheNextTime_withoutWhatHasGone() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    fixture.buildScene();
    DialogAnswerer first(
        [](Author &author) {
          author.type("title", "Sides");
          author.click("addStep");
          author.type("stepTitle", "Another");
          author.openTab(shownTab);
          author.tick("hidden", 2);
          author.click("stepUp");
        },
        {}, {});
    fixture.item().trigger();
    QVERIFY(first.isDone());
    fixture.model().history().editTogether({RemoveEntry{"d", false}}, "Delete d");
    DialogAnswerer second(
        [](Author &author) {
          QCOMPARE(author.part<QLineEdit>("title").text(), QString("Sides"));
          QCOMPARE(author.part<QListWidget>("draftSteps").item(0)->text(), QString("1  Another"));
          QCOMPARE(author.complaint(), QString());
          author.click("removeStep");
          QCOMPARE(author.part<QListWidget>("draftSteps").count(), 1);
          QVERIFY(!author.part<QPushButton>("removeStep").isEnabled());
          QVERIFY2(!author.part<QGroupBox>("question").isEnabled(), "nothing has a word");
        },
        {}, {});
    fixture.item().trigger();
    QVERIFY(second.isDone());
  }

  void dialog_fitsIntoASmallScreen() {
    AuthorFixture fixture;
    QVERIFY(fixture.ready);
    fixture.buildScene();
    DialogAnswerer asked(
        [](Author &author) {
          const QSize least = author.part<QWidget>("title").window()->minimumSizeHint();
          QVERIFY2(least.width() <= 1000 && least.height() <= 560,
                   qPrintable(QString("%1×%2").arg(least.width()).arg(least.height())));
        },
        {}, {});
    fixture.item().trigger();
    QVERIFY(asked.isDone());
  }
};

QTEST_MAIN(LessonDialogTest)
#include "lesson_dialog_test.moc"
