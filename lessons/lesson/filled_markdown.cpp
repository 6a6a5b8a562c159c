#include "lessons/lesson/filled_markdown.h"

#include "lessons/figure/mark.h"
#include "lessons/lesson/prose.h"
#include "lessons/term/written.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace halfspace {
namespace {

using Spans = std::vector<MarkdownSpan>;

bool isRounded(const FormulaSide &side) {
  const auto *number = std::get_if<LiveNumber>(&side);
  return number && showsRounded(number->term);
}

/// The relation between words or sides.
std::string spaced(const std::string &relation) { return relation.empty() ? " " : " " + relation + " "; }

/// The sides as a visitor writes each, with their relation.
template <class Writer> std::string written(const FilledFormula &formula, const Writer &writer) {
  std::string text;
  for (const FormulaSide &side : formula.sides)
    text += (text.empty() ? "" : spaced(formula.relation)) + std::visit(writer, side);
  return text;
}

/// Fills in the live values of a text, span by span.
class Filler {
public:
  Filler(const Markdown &markdown, const LiveValueOf &valueOf)
      : m_markdown(markdown), m_valueOf(valueOf), m_filled{markdown.blocks, {}} {}

  FilledMarkdown fill() {
    for (MarkdownBlock &block : m_filled.blocks)
      fill(block);
    return std::move(m_filled);
  }

private:
  void fill(MarkdownBlock &block) {
    for (MarkdownSpan &span : std::exchange(block.spans, {}))
      if (span.kind == MarkdownSpan::Kind::Formula)
        add(m_markdown.formulas[span.formula], span.face, block.spans);
      else if (span.kind == MarkdownSpan::Kind::Text)
        addText(std::move(span.text), span.face, block.spans);
      else
        block.spans.push_back(std::move(span));
    for (MarkdownBlock &child : block.children)
      fill(child);
  }

  /// What a side comes to: what stands in a formula, or a word.
  struct Shown {
    std::optional<FormulaSide> inFormula;
    std::string word{};
  };

  [[nodiscard]] Shown shown(const MarkdownFormula::Side &side) const {
    if (!side.isLive)
      return {side.text};
    LiveValue value = m_valueOf(side.text);
    if (auto *number = std::get_if<LiveNumber>(&value))
      return {std::move(*number)};
    return {std::nullopt, std::get<std::string>(std::move(value))};
  }

  void add(const MarkdownFormula &formula, const MarkdownSpan::Face &face, Spans &spans) {
    Shown first = shown(formula.sides.front());
    if (formula.sides.size() == 1)
      return add(std::move(first), formula, face, spans);
    Shown second = shown(formula.sides.back());
    if (first.inFormula && second.inFormula && areOneFormula(formula, *second.inFormula))
      return addFormula(joined(std::move(*first.inFormula), std::move(*second.inFormula), formula), face,
                        spans);
    add(std::move(first), {}, face, spans);
    addText(spaced(formula.relation), face, spans);
    add(std::move(second), formula, face, spans);
  }

  /// Whether a relation stands between the sides: that of the lesson, or the second one's own.
  static bool areOneFormula(const MarkdownFormula &formula, const FormulaSide &second) {
    return !formula.relation.empty() || !formula.sides.back().isLive || isRounded(second);
  }

  static FilledFormula joined(FormulaSide first, FormulaSide second, const MarkdownFormula &formula) {
    const bool saysEqual = formula.relation == "=";
    auto *latex = std::get_if<std::string>(&first);
    if (isRounded(second) && latex && latex->ends_with('=')) // of `$t =$ {t}`
      latex->pop_back();
    std::string relation = isRounded(second) && saysEqual ? "" : formula.relation;
    return {{std::move(first), std::move(second)}, std::move(relation), false, formula.punctuation};
  }

  /// Adds a side alone, as large as the formula and with what follows it.
  void add(Shown side, const MarkdownFormula &formula, const MarkdownSpan::Face &face, Spans &spans) {
    if (side.inFormula)
      addFormula({{std::move(*side.inFormula)}, {}, formula.large, formula.punctuation}, face, spans);
    else
      addText(side.word + formula.punctuation, face, spans);
  }

  void addFormula(FilledFormula formula, const MarkdownSpan::Face &face, Spans &spans) {
    if (isRounded(formula.sides.front()))
      dropEqualSign(spans);
    spans.push_back({MarkdownSpan::Kind::Formula, "", m_filled.formulas.size(), face});
    m_filled.formulas.push_back(std::move(formula));
  }

  /// “t = ≈ 3.14” says it twice, and once wrongly.
  static void dropEqualSign(Spans &spans) {
    constexpr std::string_view sign = "= ";
    if (spans.empty() || !spans.back().text.ends_with(sign) || spans.back().kind != MarkdownSpan::Kind::Text)
      return;
    std::string &text = spans.back().text;
    text.erase(text.size() - sign.size());
    if (text.empty())
      spans.pop_back();
  }

  static void addText(std::string text, const MarkdownSpan::Face &face, Spans &spans) {
    if (!spans.empty() && spans.back().kind == MarkdownSpan::Kind::Text && spans.back().face == face)
      spans.back().text += text;
    else
      spans.push_back({MarkdownSpan::Kind::Text, std::move(text), 0, face});
  }

  const Markdown &m_markdown;
  const LiveValueOf &m_valueOf;
  FilledMarkdown m_filled;
};

} // namespace

bool hasLiveValues(const Markdown &markdown) {
  return std::any_of(markdown.formulas.begin(), markdown.formulas.end(), [](const MarkdownFormula &formula) {
    return std::any_of(formula.sides.begin(), formula.sides.end(),
                       [](const MarkdownFormula::Side &side) { return side.isLive; });
  });
}

FilledMarkdown filledIn(const Markdown &markdown, const LiveValueOf &valueOf) {
  return Filler(markdown, valueOf).fill();
}

FilledMarkdown withNames(const Markdown &markdown) {
  return filledIn(markdown, [](const std::string &name) { return "{" + name + "}"; });
}

std::string latexOf(const FilledFormula &formula) {
  return written(formula, Overloaded{[](const std::string &latex) { return latex; },
                                     [](const LiveNumber &number) { return latexOf(number); }});
}

std::string plainText(const FilledFormula &formula, const Macros &macros) {
  const std::string sides =
      written(formula, Overloaded{[&](const std::string &latex) { return plainProse(latex, macros); },
                                  [](const LiveNumber &number) { return plainText(number); }});
  return sides + formula.punctuation;
}

} // namespace halfspace
