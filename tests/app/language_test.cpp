// The window in a language that nobody speaks: nothing in it is English, nothing has a decimal point, and
// nothing is cut off, though all words are a third longer.
#include "app/export/export_window.h"
#include "app/export/figure_export.h"
#include "app/user_language.h"
#include "tests/app/window_fixture.h"
#include "tests/lessons/lesson/pseudo_lesson.h"
#include "tests/untranslated.h"

#include "lessons/scene/hand/handles.h"
#include "widgets/hit_table/fragment_table.h"
#include "widgets/text/math_label.h"
#include "widgets/view/fitted_label.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTextDocumentFragment>
#include <QTimer>
#include <QtTest>

#include <set>

using namespace halfspace;

namespace {

/// What a screen reader says of it.
QStringList spokenOf(QWidget &widget) {
  QStringList texts;
  if (QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(&widget))
    for (const auto text :
         {QAccessible::Name, QAccessible::Description, QAccessible::Value, QAccessible::Help})
      texts << spoken->text(text);
  return texts;
}

QStringList textsOf(const QAbstractItemModel &model) {
  constexpr int fewRows = 30;
  QStringList texts;
  for (int row = 0; row < std::min(model.rowCount(), fewRows); ++row)
    for (int column = 0; column < model.columnCount(); ++column)
      for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole})
        texts << model.index(row, column).data(role).toString();
  return texts;
}

/// All texts by which a widget addresses its user.
QStringList textsOf(QWidget &widget) {
  QStringList texts = spokenOf(widget);
  texts << widget.toolTip() << widget.windowTitle() << widget.whatsThis() << widget.statusTip();
  if (const auto *button = qobject_cast<QAbstractButton *>(&widget))
    texts << button->text();
  if (const auto *label = qobject_cast<QLabel *>(&widget))
    texts << label->text();
  if (const auto *field = qobject_cast<QLineEdit *>(&widget))
    texts << field->placeholderText() << field->text();
  if (const auto *combo = qobject_cast<QComboBox *>(&widget))
    texts << textsOf(*combo->model());
  if (const auto *view = qobject_cast<QAbstractItemView *>(&widget); view && view->model())
    texts << textsOf(*view->model());
  for (const QAction *action : widget.actions())
    texts << action->text() << action->toolTip() << action->statusTip();
  return texts;
}

std::string plainText(const QString &text) {
  return (Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text)
      .toStdString();
}

/// A label that is never shown, but tells how much room others need.
bool isOnlyRoom(const QWidget &widget) {
  return widget.objectName() == "usualCase" || widget.objectName() == "usualNearby";
}

/// What shows a part of its words on purpose: it scrolls, says the rest where the pointer rests on it, or
/// draws them smaller.
bool mayBeCut(const QWidget &widget) {
  return qobject_cast<const FittedLabel *>(&widget) || qobject_cast<const FragmentTable *>(&widget) ||
         qobject_cast<const MathLabel *>(&widget) || qobject_cast<const QAbstractScrollArea *>(&widget);
}

/// Whether a widget that has nothing but words in it has less room than they need.
bool isCut(QWidget &widget) {
  if (const auto *label = qobject_cast<QLabel *>(&widget))
    return !label->text().isEmpty() &&
           (label->wordWrap() ? label->heightForWidth(label->width()) > label->height()
                              : label->sizeHint().width() > label->width());
  if (const auto *button = qobject_cast<QAbstractButton *>(&widget))
    return !button->hasHeightForWidth() && button->sizeHint().width() > button->width();
  return widget.hasHeightForWidth() && widget.heightForWidth(widget.width()) > widget.height();
}

/// So that all that waits to be placed has its place.
void settle() {
  for (int round = 0; round < 3; ++round) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }
}

} // namespace

class LanguageTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("halfspace-test");
    QCoreApplication::setApplicationName("language");
    qputenv("HALFSPACE_LANGUAGE", "pseudo");
    setUserLanguage();
    translateWindows(*QCoreApplication::instance());
    forgetStarts();
    m_fixture = std::make_unique<WindowFixture>("signed-distance",
                                                test::inPseudoLanguage(readLessons(TEST_LESSONS_FOLDER)));
    QVERIFY(m_fixture->ready);
  }
  void cleanupTestCase() { m_fixture.reset(); }
  void init() {
    m_english.clear();
    m_cut.clear();
  }
  void cleanup() {
    for (const QStringList &found : {m_english, m_cut})
      QVERIFY2(found.isEmpty(), qPrintable("\n" + found.join('\n')));
  }

  void steps_ofAllLessons_openAndAnswered() {
    for (const std::string &id : lessonIds()) {
      model().openLesson(id);
      for (int step = 0; step < int(model().lesson().steps.size()); ++step) {
        model().setStep(step);
        look(QString("%1, step %2").arg(id.c_str()).arg(step + 1));
        if (predictionOf(stepOf(model().lesson(), step))) {
          m_fixture->answer(0);
          look(QString("%1, step %2, answered").arg(id.c_str()).arg(step + 1));
        }
      }
    }
  }

  void handles_ofAllKinds() {
    std::set<std::string_view> kinds;
    for (const std::string &id : lessonIds()) {
      model().openLesson(id);
      for (const Handle &handle : handlesOf(model().session().scene))
        if (kinds.insert(kindOf(*findObject(model().session().scene, handle.object))).second) {
          m_fixture->scene().handles().select(handle.id);
          look(QString("%1, handle %2").arg(id.c_str(), handle.id.c_str()));
        }
    }
  }

  void blanks_andWrongAnswers() {
    model().openLesson("signed-distance");
    m_fixture->goToLine("distance");
    const auto choices = m_fixture->practice().findChild<QToolButton *>("fading")->menu()->actions();
    for (QAction *choice : choices) {
      choice->trigger();
      look("blanks: " + choice->text());
    }
    for (const char *typed : {"1", "words", "(1; 2)", "x = 1", "30"})
      if (auto *field = m_fixture->practice().findChild<QLineEdit *>()) {
        field->setText(typed);
        QTest::keyClick(field, Qt::Key_Return);
        look(QString("typed ") + typed);
      }
  }

  void numbers_thatAreRefused() {
    model().openLesson("signed-distance");
    NumberField *field = m_fixture->field("Q", 0);
    QVERIFY(field);
    for (const char *typed :
         {"1,2,3", "99999999999", "1/3333333333333333333333333333333333333333333333333"}) {
      field->setText(typed);
      field->enter();
      look(QString("typed ") + typed);
    }
    field->drop();
  }

  void exportWindow_ofEachFormat() {
    model().openLesson("reflection");
    m_fixture->window.findChild<FigureExport *>()->open();
    auto &window = *m_fixture->window.findChild<ExportWindow *>();
    QSignalSpy previewed(&window, &ExportWindow::previewed);
    auto &formats = *window.findChild<QComboBox *>("format");
    for (int format = 0; format < formats.count(); ++format) {
      formats.setCurrentIndex(format);
      QVERIFY(previewed.wait());
      look("export as " + formats.currentText());
    }
    const QTemporaryDir folder;
    window.saveTo(folder.filePath("figure.svg"));
    auto &message = *window.findChild<QLabel *>("exportMessage");
    QTRY_VERIFY(message.text().contains("figure.svg"));
    look("exported");
    window.saveTo("/nowhere/figure.svg");
    QTRY_VERIFY(message.text().contains("/nowhere"));
    look("not exported");
    window.close();
  }

  void dialogs_ofTheHelpMenu() {
    for (QAction *action : m_fixture->window.menuBar()->actions().last()->menu()->actions()) {
      bool isOpen = false;
      QTimer::singleShot(0, this, [&] {
        QWidget *dialog = QApplication::activeModalWidget();
        isOpen = dialog;
        if (!dialog)
          return;
        look("dialog " + dialog->windowTitle());
        dialog->close();
      });
      action->trigger();
      QVERIFY(isOpen);
    }
  }

private:
  SessionModel &model() { return m_fixture->model(); }

  std::vector<std::string> lessonIds() {
    std::vector<std::string> ids;
    for (const Lesson &lesson : model().library().lessons)
      ids.push_back(lesson.id);
    return ids;
  }

  /// Looks at all widgets of all windows. What was seen once is not looked at again.
  void look(const QString &where) {
    settle();
    test::Names names{"Halfspace"};
    for (const Entry &entry : model().session().scene.entries)
      names.insert(entry.name);
    for (QWidget *widget : QApplication::allWidgets()) {
      const QString what =
          QString("%1: %2 %3").arg(where, widget->metaObject()->className(), widget->objectName());
      for (const QString &text : textsOf(*widget))
        if (!text.isEmpty() && m_seen.insert(text).second && !isOnlyRoom(*widget))
          judge(plainText(text), names, what);
      if (widget->isVisible() && !mayBeCut(*widget) && isCut(*widget))
        m_cut << QString("cut off: %1 “%2”").arg(what, textsOf(*widget).join(" | "));
    }
  }

  void judge(const std::string &text, const test::Names &names, const QString &what) {
    if (!test::untranslatedIn(text, names).empty())
      m_english << QString("not translated: %1 “%2”").arg(what, text.c_str());
    if (test::hasDecimalPoint(text))
      m_english << QString("decimal point: %1 “%2”").arg(what, text.c_str());
  }

  std::unique_ptr<WindowFixture> m_fixture;
  std::set<QString> m_seen;
  QStringList m_english;
  QStringList m_cut;
};

QTEST_MAIN(LanguageTest)
#include "language_test.moc"
