#include "widgets/handout/styled_text.h"

#include "widgets/formula/index_runs.h"

#include <utility>

namespace halfspace {

InlineText inlineText(std::string_view plain, TextLook look) {
  InlineText text;
  for (math::IndexRun &run : math::indexRunsOf(plain)) {
    look.isIndex = run.isIndex;
    if (!run.text.empty())
      text.emplace_back(StyledWords{std::move(run.text), look, std::move(run.written)});
  }
  return text;
}

} // namespace halfspace
