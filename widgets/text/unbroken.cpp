#include "widgets/text/unbroken.h"

#include <QRegularExpression>

namespace halfspace {

QString unbroken(QString text) {
  static const QRegularExpression besideRelation(QStringLiteral("(?<=\\S) ([=≈<>≤≥]) (?=\\S)"));
  text.replace(besideRelation, QChar(QChar::Nbsp) + QStringLiteral("\\1") + QChar(QChar::Nbsp));
  // Lines may break behind a bar, even before a space that else joins.
  return text.replace(QChar('|'), QStringLiteral("|") + wordJoiner);
}

QString breakable(QString text) { return text.remove(wordJoiner).replace(QChar(QChar::Nbsp), QChar(' ')); }

} // namespace halfspace
