// A value with a long name, in narrow and wide panels.
#include "widgets/numbers/named_value_row.h"

#include <QTest>
#include <QVBoxLayout>

using namespace halfspace;

namespace {

math::Row formulaOf(const std::string &text) { return {math::words(text)}; }

} // namespace

class NamedValueRowTest : public QObject {
  Q_OBJECT

private slots:
  void value_besideALongName_goesBelowItWhereThePanelIsNarrow() {
    Typesetter typesetter;
    NamedValueRow row(typesetter);
    row.name().setFormula({math::words("signed distance of the origin")}, "");
    row.value().setFormula(math::row(math::number("-27"), math::words(" divided by three")), "");
    row.show();
    QVERIFY(row.value().sizeHint().width() > 0 && row.name().sizeHint().width() > 0);
    row.resize(800, row.heightForWidth(800));
    QVERIFY(row.value().x() >= row.name().sizeHint().width());
    QCOMPARE(row.value().y(), 0);
    const int narrow = row.name().sizeHint().width() + 10;
    QVERIFY(row.heightForWidth(narrow) > row.heightForWidth(800));
    row.resize(narrow, row.heightForWidth(narrow));
    QVERIFY(row.value().y() >= row.name().sizeHint().height());
    QVERIFY2(row.value().width() >= row.value().sizeHint().width(), "the value has its full size");
  }

  void values_besideShortNames_standInOneColumn() {
    Typesetter typesetter;
    NamedValueRow shortRow(typesetter);
    NamedValueRow longerRow(typesetter);
    shortRow.name().setFormula(formulaOf("t"), "");
    longerRow.name().setFormula(formulaOf("dist"), "");
    for (NamedValueRow *row : {&shortRow, &longerRow}) {
      row->value().setFormula(math::number("-27"), "");
      row->resize(400, row->heightForWidth(400));
      row->show();
    }
    QVERIFY(shortRow.name().sizeHint().width() < longerRow.name().sizeHint().width());
    QCOMPARE(shortRow.value().x(), longerRow.value().x());
  }

  void value_thatGrowsWhileItIsShown_isGivenItsRoom() {
    Typesetter typesetter;
    NamedValueRow row(typesetter);
    row.name().setFormula(formulaOf("t"), "");
    row.value().setFormula(math::number("1"), "");
    row.resize(row.sizeHint());
    row.show();
    QCOMPARE(row.value().y(), 0);
    row.value().setFormula(formulaOf("a value that is much longer than before"), "");
    QTRY_VERIFY(row.value().y() > 0); // there is no room for it beside the name any more
    QVERIFY(row.sizeHint().width() > row.width());
  }

  void value_thatGrewWhileItWasHidden_hasItsRoomWhenItIsShown() {
    Typesetter typesetter;
    QWidget panel;
    auto *column = new QVBoxLayout(&panel);
    auto *row = new NamedValueRow(typesetter);
    row->name().setFormula(formulaOf("t"), "");
    row->value().setFormula(math::number("1"), "");
    column->addWidget(row);
    column->addStretch(1);
    panel.resize(400, 300);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const int before = row->height();
    panel.hide();
    row->value().setFormula({math::fraction({math::number("1")}, {math::number("3")})}, "");
    panel.show();
    QTRY_VERIFY(row->height() > before);
  }
};

QTEST_MAIN(NamedValueRowTest)
#include "named_value_row_test.moc"
