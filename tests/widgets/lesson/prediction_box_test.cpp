// A question with its choices: answering it, and what is told then.
#include "widgets/lesson/prediction_box.h"

#include "widgets/colors.h"

#include <QPixmap>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

using namespace halfspace;

namespace {

Prediction question() {
  return {"On which side is $Q$?",
          "side",
          {{"positive", "The side of $\\vec n$"}, {"negative", "The other side"}, {"on", "In the plane"}},
          "The sign of $f(Q)$ tells."};
}

struct ShownBox {
  ShownBox() {
    box.setTheme(themes().front());
    box.resize(400, 300);
    box.show();
    ready = QTest::qWaitForWindowExposed(&box);
  }
  std::vector<Verdict> verdicts() const {
    std::vector<Verdict> each;
    for (const ChoiceButton *choice : box.choices())
      each.push_back(choice->verdict());
    return each;
  }
  QString reason() const { return box.reason()->isVisible() ? box.reason()->plain() : QString(); }

  Typesetter typesetter;
  PredictionBox box{typesetter, question()};
  QSignalSpy chosen{&box, &PredictionBox::chosen};
  bool ready = false;
};

/// Whether a colour is where the verdict has its mark.
bool paintsMark(ChoiceButton &choice, Color ink) {
  const QImage image = choice.grab().toImage();
  for (int x = 0; x < 34; ++x)
    if (image.pixelColor(x, image.height() / 2).rgb() == toQColor(ink).rgb())
      return true;
  return false;
}

using enum Verdict;

} // namespace

class PredictionBoxTest : public QObject {
  Q_OBJECT

private slots:
  void choice_clickedOrPressedByAKey_isToldByItsWord() {
    ShownBox shown;
    QVERIFY(shown.ready);
    QTest::mouseClick(shown.box.choices()[2], Qt::LeftButton);
    QCOMPARE(shown.chosen.takeFirst().at(0).toString(), QString("on"));
    shown.box.choices()[0]->setFocus();
    QTest::keyClick(shown.box.choices()[0], Qt::Key_Space);
    QCOMPARE(shown.chosen.takeFirst().at(0).toString(), QString("positive"));
  }

  void words_onAChoice_areClickedThrough() {
    ShownBox shown;
    QVERIFY(shown.ready);
    QWidget *words = shown.box.choices()[1]->findChild<RichLabel *>();
    const QPoint middle = words->mapTo(&shown.box, words->rect().center());
    QCOMPARE(shown.box.childAt(middle), static_cast<QWidget *>(shown.box.choices()[1]));
  }

  void answer_givenRight_isMarkedAloneAndExplained() {
    ShownBox shown;
    shown.box.setAnswer(GivenAnswer{"negative", "negative"});
    QVERIFY((shown.verdicts() == std::vector{Open, Right, Open}));
    QCOMPARE(shown.reason(), QString("Right. The sign of f(Q) tells."));
    QCOMPARE(shown.box.choices()[1]->accessibleDescription(), QString("Right"));
  }

  void answer_givenWrong_isMarkedBesideTheRightOne() {
    ShownBox shown;
    shown.box.setAnswer(GivenAnswer{"on", "positive"});
    QVERIFY((shown.verdicts() == std::vector{Right, Open, Wrong}));
    QVERIFY2(shown.reason().startsWith("Not quite."), qPrintable(shown.reason()));
    QCOMPARE(shown.box.choices()[2]->accessibleDescription(), QString("Wrong"));
  }

  void reason_thatBeginsWithAList_staysOneBehindTheVerdict() {
    Prediction asked = question();
    asked.reason = "- The sign tells.\n- So does the side.";
    Typesetter typesetter;
    PredictionBox box(typesetter, asked);
    box.show();
    box.setAnswer(GivenAnswer{"negative", "negative"});
    const QString reason = box.reason()->plain();
    QVERIFY2(reason.startsWith("Right."), qPrintable(reason));
    QVERIFY2(!reason.contains("- The"), "its mark is no letter");
    QVERIFY2(!reason.startsWith("Right. The sign"), "the list begins in a line of its own");
  }

  void answer_toAnotherScene_keepsItsVerdictAndSaysSo() {
    ShownBox shown;
    shown.box.setAnswer(GivenAnswer{"negative", "negative", false});
    QVERIFY((shown.verdicts() == std::vector{Open, Right, Open}));
    QVERIFY2(shown.reason().startsWith("Right. That was"), qPrintable(shown.reason()));
    QVERIFY(shown.reason().contains("The sign of f(Q) tells."));
  }

  void tryingAgain_isOfferedWhereThereIsSomethingToMend_data() {
    QTest::addColumn<QString>("chosen");
    QTest::addColumn<bool>("isOfNow");
    QTest::addColumn<bool>("isOffered");
    QTest::newRow("right") << "negative" << true << false;
    QTest::newRow("wrong, and the right one is shown") << "on" << true << false;
    QTest::newRow("right, about another scene") << "negative" << false << true;
    QTest::newRow("wrong, about another scene") << "on" << false << true;
  }

  void tryingAgain_isOfferedWhereThereIsSomethingToMend() {
    QFETCH(QString, chosen);
    QFETCH(bool, isOfNow);
    QFETCH(bool, isOffered);
    ShownBox shown;
    shown.box.setAnswer(GivenAnswer{chosen.toStdString(), "negative", isOfNow});
    QCOMPARE(shown.box.findChild<QToolButton *>("again")->isVisibleTo(&shown.box), isOffered);
  }

  void verdict_ofAnotherScene_isGrey() {
    ShownBox shown;
    QVERIFY(shown.ready);
    shown.box.setAnswer(GivenAnswer{"on", "positive", false});
    const Theme &theme = themes().front();
    for (const int choice : {0, 2})
      QVERIFY(paintsMark(*shown.box.choices()[choice], theme.mutedInk));
    QVERIFY(!paintsMark(*shown.box.choices()[0], theme.inkOf(Subject::Triangle)));
    QVERIFY(!paintsMark(*shown.box.choices()[2], theme.warning));
    QCOMPARE(shown.box.choices()[0]->accessibleDescription(), QString("Right before the change"));
  }

  void answer_whereNoneIsRight_isExplainedWithoutAVerdict() {
    ShownBox shown;
    shown.box.setAnswer(GivenAnswer{"on", ""});
    QVERIFY((shown.verdicts() == std::vector{Open, Open, Open}));
    QCOMPARE(shown.reason(), QString("The sign of f(Q) tells."));
  }

  void choices_afterTheAnswer_areAnsweredAndAskedAgainWithIt() {
    ShownBox shown;
    QVERIFY(shown.ready);
    QCOMPARE(shown.reason(), QString());
    shown.box.setAnswer(GivenAnswer{"on", "positive"});
    QTest::mouseClick(shown.box.choices()[1], Qt::LeftButton);
    QVERIFY(shown.chosen.isEmpty());
    shown.box.setAnswer({});
    QCOMPARE(shown.reason(), QString());
    QVERIFY((shown.verdicts() == std::vector{Open, Open, Open}));
    QCOMPARE(shown.box.choices()[2]->accessibleDescription(), QString());
    QTest::mouseClick(shown.box.choices()[1], Qt::LeftButton);
    QCOMPARE(shown.chosen.count(), 1);
  }

  void verdict_onAChoice_isPaintedInItsInk_data() {
    QTest::addColumn<int>("choice");
    QTest::addColumn<bool>("isRight");
    QTest::newRow("right") << 0 << true;
    QTest::newRow("wrong") << 2 << false;
  }

  void verdict_onAChoice_isPaintedInItsInk() {
    QFETCH(int, choice);
    QFETCH(bool, isRight);
    const Theme &theme = themes().front();
    const Color ink = isRight ? theme.inkOf(Subject::Triangle) : theme.warning;
    ShownBox shown;
    QVERIFY(shown.ready);
    QVERIFY(!paintsMark(*shown.box.choices()[choice], ink));
    shown.box.setAnswer(GivenAnswer{"on", "positive"});
    QVERIFY(paintsMark(*shown.box.choices()[choice], ink));
  }
};

QTEST_MAIN(PredictionBoxTest)
#include "prediction_box_test.moc"
