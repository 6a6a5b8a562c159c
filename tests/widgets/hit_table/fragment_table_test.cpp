// The table of fragments: what it shows, how high it is, and what is chosen in it.
#include "widgets/hit_table/fragment_table.h"

#include "tests/widgets/flight/some_crossings.h"
#include "tests/widgets/pointer.h"
#include "widgets/colors.h"

#include <QAccessible>
#include <QPixmap>
#include <QtTest>

using namespace halfspace;
using namespace halfspace::test;

namespace {

struct ShownTable {
  explicit ShownTable(const Typesetter &typesetter) : table(typesetter) {
    QObject::connect(&table, &FragmentTable::chosen,
                     [this](std::size_t number) { chosen.push_back(number); });
    QObject::connect(&table, &FragmentTable::hovered,
                     [this](std::size_t number) { hovered.push_back(number); });
    show(someCrossings());
  }
  void show(const Crossings &crossings, LiveValues values = LiveValues::Shown) {
    table.setCrossings(crossings, values);
    table.resize(430, table.heightForWidth(430));
  }
  QImage imageOf(std::size_t row) { return table.grab(table.rowRect(row)).toImage(); }
  int pixelsOf(std::size_t row, const QColor &ink) {
    const QImage image = imageOf(row);
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        count += image.pixelColor(x, y).rgb() == ink.rgb();
    return count;
  }

  FragmentTable table;
  std::vector<std::size_t> chosen;
  std::vector<std::size_t> hovered;
};

using Numbers = std::vector<std::size_t>;
const Theme &theme() { return themes().front(); }

} // namespace

class FragmentTableTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void row_ofTheNearest_aloneHasTheResultsInk() {
    ShownTable shown(m_typesetter);
    const QColor result = toQColor(theme().inkOf(Subject::Ray));
    for (std::size_t row = 0; row < shown.table.rows().size(); ++row)
      QCOMPARE(shown.pixelsOf(row, result) > 40, shown.table.rows()[row].crossing.number == 3);
  }

  void rows_ofLaterHits_haveTheUsualInk_missesDoNot() {
    ShownTable shown(m_typesetter);
    QVERIFY(shown.pixelsOf(2, toQColor(theme().ink)) > 20);
    QCOMPARE(shown.pixelsOf(4, toQColor(theme().ink)), 0);
  }

  void row_thatIsChosen_isHighlighted() {
    ShownTable shown(m_typesetter);
    const QImage before = shown.imageOf(2);
    Crossings crossings = someCrossings();
    crossings.chosen = 1;
    shown.show(crossings);
    QVERIFY(shown.imageOf(2) != before);
  }

  void click_onARow_choosesItsFragment_andLeavesTheTableAsItIs() {
    ShownTable shown(m_typesetter);
    const QImage before = shown.imageOf(1);
    QTest::mouseClick(&shown.table, Qt::LeftButton, {}, shown.table.rowRect(1).center());
    QTest::mouseClick(&shown.table, Qt::LeftButton, {}, shown.table.rowRect(5).center());
    QCOMPARE(shown.chosen, (Numbers{3, 2}));
    QTest::mouseClick(&shown.table, Qt::LeftButton, {}, {20, 3}); // the head
    QCOMPARE(shown.chosen.size(), std::size_t(2));
    QVERIFY(shown.imageOf(1) == before);
  }

  void keys_goFromTheChosenRow() {
    ShownTable shown(m_typesetter);
    QTest::keyClick(&shown.table, Qt::Key_Down);
    Crossings crossings = someCrossings();
    crossings.chosen = 3;
    shown.show(crossings);
    QTest::keyClick(&shown.table, Qt::Key_Down);
    QTest::keyClick(&shown.table, Qt::Key_Up);
    QTest::keyClick(&shown.table, Qt::Key_Return);
    QCOMPARE(shown.chosen, (Numbers{4, 1, 4, 3}));
  }

  void pointer_overRows_tellsEachOnce_andLeaves() {
    ShownTable shown(m_typesetter);
    movePointer(shown.table, shown.table.rowRect(1).center());
    movePointer(shown.table, shown.table.rowRect(1).center() + QPoint(5, 0));
    movePointer(shown.table, shown.table.rowRect(2).center());
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&shown.table, &leave);
    QCOMPARE(shown.hovered, (Numbers{3, 1, 0}));
  }

  void hidden_tellsNothing_neitherInInkNorInWords() {
    ShownTable shown(m_typesetter);
    shown.show(someCrossings(), LiveValues::Hidden);
    Crossings others = someCrossings();
    others.all[1].at->t = Rational(1, 3);
    std::swap(others.all[1].which, others.all[4].which);
    others.nearest = 1;
    for (std::size_t row = 0; row < 6; ++row)
      QVERIFY(!shown.table.spoken(row).contains("1/2") && !shown.table.spoken(row).contains("hit"));
    const QImage before = shown.table.grab().toImage();
    shown.show(others, LiveValues::Hidden);
    QVERIFY(shown.table.grab().toImage() == before);
  }

  void height_whileHeld_onlyGrows() {
    ShownTable shown(m_typesetter);
    const int usual = shown.table.heightForWidth(430);
    shown.table.setHeld(true);
    Crossings fewer = someCrossings();
    fewer.all.pop_back();
    fewer.fragments = 5;
    shown.table.setCrossings(fewer);
    QCOMPARE(shown.table.heightForWidth(430), usual);
    shown.table.setHeld(false);
    QVERIFY(shown.table.heightForWidth(430) < usual);
  }

  void columns_asNumbersBecomeLonger_stayWhereTheyAre() {
    ShownTable shown(m_typesetter);
    const QImage ofLonger = shown.imageOf(1);
    const QImage ofOther = shown.imageOf(3);
    Crossings longer = someCrossings();
    longer.all[1].at->s = Rational(12, 175); // as long as they are written exactly
    shown.show(longer);
    QVERIFY(shown.imageOf(1) != ofLonger);
    QCOMPARE(shown.imageOf(3), ofOther);
  }

  void column_withALongNumber_isOfDecimalsAndItsHeadSaysSo_theOthersStay() {
    ShownTable shown(m_typesetter);
    const auto areaOf = [&](int from, int to) {
      return shown.table.grab(QRect(from, 0, to - from, 400)).toImage();
    };
    const QImage first = shown.imageOf(4); // λ = 7/4
    const QImage behind = areaOf(250, 430);
    Crossings longer = someCrossings();
    longer.all[0].at->t = Rational(-1234, 5679);
    shown.show(longer);
    QVERIFY(shown.imageOf(4) != first); // λ ≈ 1.75
    QCOMPARE(areaOf(250, 430), behind);
    QVERIFY(shown.table.spoken(0).contains("-1234/5679") || shown.table.spoken(0).contains("−1234/5679"));
  }

  void column_withADecimal_hasNoFractions() {
    ShownTable shown(m_typesetter);
    Crossings crossings = someCrossings();
    crossings.all[1].at->t = Rational(3, 5);
    shown.show(crossings);
    const QImage alone = shown.imageOf(1); // λ = 3/5
    crossings.all[0].at->t = Rational(-9, 40);
    shown.show(crossings);
    QVERIFY(shown.imageOf(1) != alone); // λ = 0.6, as the other is −0.225
  }

  void narrowTable_hasHigherRows_noWiderThanItself() {
    ShownTable shown(m_typesetter);
    shown.table.resize(700, shown.table.heightForWidth(700));
    const int wide = shown.table.rowRect(0).height();
    shown.table.resize(220, shown.table.heightForWidth(220));
    QVERIFY(shown.table.rowRect(0).height() > wide * 3 / 2);
    QVERIFY(shown.table.rowRect(0).right() < 220);
  }

  void lastLine_ofMoreThanItShows_countsTheRest() {
    ShownTable shown(m_typesetter);
    Crossings many = someCrossings();
    many.all.erase(many.all.begin());
    many.all.pop_back();
    for (std::size_t i = 7; i < 39; ++i)
      many.all.push_back(crossingAt(i, RayTriangleCase::Miss, Rational(2)));
    many.fragments = many.all.size();
    shown.show(many);
    QCOMPARE(shown.table.rows().size(), FragmentTable::mostRows);
    QCOMPARE(shown.table.leftOutWords(), QString("and 22 more outside"));
  }

  void speech_ofARow_hasItsNumbers() {
    ShownTable shown(m_typesetter);
    QCOMPARE(shown.table.spoken(1), QString("barn 3: λ = 1/2, hit first, s = 1/4, t = 3/8"));
  }

  void speech_ofTheTable_isAListOfAllRows() {
    ShownTable shown(m_typesetter);
    const QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(&shown.table);
    QCOMPARE(spoken->role(), QAccessible::List);
    QVERIFY(spoken->text(QAccessible::Description).startsWith("barn 4: λ = −1/4, behind the start, s = 1/4"));
    QVERIFY(spoken->text(QAccessible::Description).endsWith("barn 2: parallel"));
  }
};

QTEST_MAIN(FragmentTableTest)
#include "fragment_table_test.moc"
