#include "widgets/unbroken.h"

#include <QRegularExpression>

namespace halfspace {

QString unbroken(QString text) {
  static const QRegularExpression besideRelation(QStringLiteral("(?<=\\S) ([=≈<>≤≥]) (?=\\S)"));
  static const QRegularExpression openingBar(QStringLiteral("\\|(?=\\w)"));
  constexpr QChar wordJoiner(0x2060);
  text.replace(besideRelation, QChar(QChar::Nbsp) + QStringLiteral("\\1") + QChar(QChar::Nbsp));
  return text.replace(openingBar, QStringLiteral("|") + wordJoiner);
}

} // namespace halfspace
