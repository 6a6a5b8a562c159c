// What a block gives away of its lines.
#pragma once

#include "widgets/working/working_block.h"

#include <QStringList>

namespace halfspace {

/// The formulas as LaTeX, each in a line.
inline QString latexIn(const WorkingBlock &block) {
  QStringList formulas;
  for (const ToldLine &told : block.toldLines())
    formulas << QString::fromStdString(formulaText(told, DocumentFormat::Latex));
  return formulas.join(u'\n');
}

} // namespace halfspace
