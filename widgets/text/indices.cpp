#include "widgets/text/indices.h"

#include <QFontInfo>
#include <QLabel>
#include <QRegularExpression>

namespace halfspace {
namespace {

constexpr double indexScale = 0.7; // as formulas have it
constexpr double indexDropEms = 0.18;

} // namespace

std::vector<TextRun> runsOf(const QString &plain) {
  static const QRegularExpression index(QStringLiteral("(?<=[\\p{L}\\p{M}\\p{No}′])_([\\p{L}\\p{N}]+)"),
                                        QRegularExpression::UseUnicodePropertiesOption);
  std::vector<TextRun> runs;
  int end = 0;
  for (auto found = index.globalMatch(plain); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    runs.push_back({plain.mid(end, match.capturedStart() - end)});
    runs.push_back({match.captured(1), true});
    end = static_cast<int>(match.capturedEnd());
  }
  if (end < plain.size() || runs.empty())
    runs.push_back({plain.mid(end)});
  return runs;
}

QString richTextOf(const QString &plain) {
  QString rich;
  for (const TextRun &run : runsOf(plain))
    rich += run.isIndex ? QStringLiteral("<sub>%1</sub>").arg(run.text) : run.text.toHtmlEscaped();
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
