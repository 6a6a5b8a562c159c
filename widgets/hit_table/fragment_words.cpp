#include "widgets/hit_table/fragment_words.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/written.h"
#include "widgets/text/figures.h"

#include <QCoreApplication>

namespace halfspace {
namespace {

struct FragmentWords {
  Q_DECLARE_TR_FUNCTIONS(halfspace::FragmentWords)
};

QString spokenNumber(const char *name, const Rational &value) {
  return QString::fromUtf8(name) + QString::fromStdString(relatedText(written(value)));
}

} // namespace

QString headOfNames() { return FragmentWords::tr("fragment"); }

QString headOfVerdicts() { return FragmentWords::tr("verdict"); }

QString verdictOf(const FragmentRow &row, LiveValues values) {
  return values == LiveValues::Hidden ? QStringLiteral("?") : wordsOf(row.standing);
}

QString shortVerdictOf(const FragmentRow &row, LiveValues values) {
  return values == LiveValues::Hidden ? verdictOf(row, values) : shortWordsOf(row.standing);
}

QString spokenRow(const FragmentRow &row, LiveValues values) {
  if (values == LiveValues::Hidden)
    return FragmentWords::tr("%1: hidden while the question is open")
        .arg(QString::fromStdString(row.crossing.name));
  QString sentence = sentenceOf(row.crossing, row.standing);
  if (!hidesNumbers(row, values) && row.crossing.at)
    sentence +=
        ", " + spokenNumber("s", row.crossing.at->s) + ", " + spokenNumber("t", row.crossing.at->tTriangle);
  return sentence;
}

QString leftOutWords(const FragmentRows &shown) {
  if (shown.leftOut == 0)
    return {};
  const QString count = counted(shown.leftOut);
  const int form = formOf(shown.leftOut);
  return shown.leftOutAreOutside ? FragmentWords::tr("and %1 more outside", nullptr, form).arg(count)
                                 : FragmentWords::tr("and %1 more", nullptr, form).arg(count);
}

} // namespace halfspace
