#include "widgets/text/formula_among_words.h"

#include "widgets/formula/formula_among_words.h"

namespace halfspace {

Typesetter::Picture pictureOf(const FilledFormula &formula, const Typesetter &typesetter) {
  if (const auto row = rowAmongWords(formula, typesetter.macros())) {
    auto picture = typesetter.picture(*row);
    if (picture->error().isEmpty())
      return picture;
  }
  // Columns are counted, and the source is shown, as they were written.
  return typesetter.picture(QString::fromStdString(latexOf(formula) + formula.punctuation));
}

} // namespace halfspace
