#include "widgets/text/indices.h"

#include "widgets/formula/index_runs.h"

#include <QFontInfo>
#include <QLabel>

namespace halfspace {
namespace {

/// More than formulas have: words are set smaller than those.
constexpr double indexScale = 0.8;
constexpr double indexDropEms = 0.18;

} // namespace

std::vector<TextRun> runsOf(const QString &plain) {
  std::vector<TextRun> runs;
  for (const math::IndexRun &run : math::indexRunsOf(plain.toStdString()))
    runs.push_back({QString::fromStdString(run.text), run.isIndex});
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
