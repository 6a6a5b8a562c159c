#include "widgets/text/indices.h"

#include <QFontInfo>
#include <QLabel>
#include <QRegularExpression>

namespace halfspace {
namespace {

/// More than formulas have: words are set smaller than those.
constexpr double indexScale = 0.8;
constexpr double indexDropEms = 0.18;

/// Small digits ahead of a letter's index belong to it: P₀_E has the index 0,E, as in formulas.
QString indexOf(const QString &smallDigits, const QString &index) {
  QString whole;
  for (const QChar digit : smallDigits)
    whole += QChar(u'0' + digit.unicode() - u'₀');
  return whole.isEmpty() ? index : whole + u',' + index;
}

} // namespace

std::vector<TextRun> runsOf(const QString &plain) {
  static const QRegularExpression index(
      QStringLiteral("(?<=[\\p{L}\\p{M}\\p{No}′])([₀-₉]*)_([\\p{L}\\p{N}]+)"),
      QRegularExpression::UseUnicodePropertiesOption);
  std::vector<TextRun> runs;
  int end = 0;
  for (auto found = index.globalMatch(plain); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    runs.push_back({plain.mid(end, match.capturedStart() - end)});
    runs.push_back({indexOf(match.captured(1), match.captured(2)), true});
    end = static_cast<int>(match.capturedEnd());
  }
  if (end < plain.size() || runs.empty())
    runs.push_back({plain.mid(end)});
  return runs;
}

QString richTextOf(const QString &plain) {
  QString rich;
  // Qt sets indices at two thirds of the size, and what is big at 1.2 of that.
  for (const TextRun &run : runsOf(plain))
    rich += run.isIndex ? QStringLiteral("<sub><big>%1</big></sub>").arg(run.text) : run.text.toHtmlEscaped();
  return rich;
}

void showWords(QLabel &label, const QString &plain) {
  const bool hasIndices = runsOf(plain).size() > 1;
  label.setTextFormat(hasIndices ? Qt::RichText : Qt::PlainText);
  label.setText(hasIndices ? richTextOf(plain) : plain);
}

QFont indexFont(QFont text) {
  text.setPixelSize(qRound(indexScale * QFontInfo(text).pixelSize()));
  return text;
}

double indexDrop(const QFont &text) { return indexDropEms * QFontInfo(text).pixelSize(); }

} // namespace halfspace
