// A value with a long name, in narrow and wide panels.
#include "widgets/numbers/named_value_row.h"

#include <QTest>

using namespace halfspace;

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
};

QTEST_MAIN(NamedValueRowTest)
#include "named_value_row_test.moc"
