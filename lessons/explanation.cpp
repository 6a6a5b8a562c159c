#include "lessons/explanation.h"

#include "lessons/formula.h"

#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

Json exactOf(const Surd &number) {
  const auto text = toText(number);
  return text ? Json(*text) : Json();
}

/// A value as in the eval format. A double beyond their range becomes null by itself.
struct ValueJson {
  Json operator()(const Surd &number) const {
    return {{"value", toDouble(number)}, {"exact", exactOf(number)}};
  }
  Json operator()(const std::vector<Surd> &list) const {
    Json values = Json::array();
    Json exact = Json::array();
    for (const Surd &number : list) {
      values.push_back(toDouble(number));
      exact.push_back(exactOf(number));
    }
    return {{"value", values}, {"exact", exact}};
  }
  Json operator()(const std::string &word) const { return word; }
  Json operator()(int number) const { return number; }
  Json operator()(const std::vector<NamedValue> &group) const {
    Json json = Json::object();
    for (const NamedValue &each : group)
      json[each.name] = std::visit(*this, each.value);
    return json;
  }
};

/// `= 10`, `≈ 3.16228`, `: positive`: what follows a value's name.
struct ValueText {
  std::string operator()(const Surd &number) const {
    return related([&](Formula &f) { return f(number); });
  }
  std::string operator()(const std::vector<Surd> &list) const {
    return related([&](Formula &f) { return f.list(list); });
  }
  std::string operator()(const std::string &word) const { return ": " + word; }
  std::string operator()(int number) const { return (*this)(Surd(number)); }
  std::string operator()(const std::vector<NamedValue> &) const { return {}; }

private:
  template <class Write> static std::string related(Write write) {
    Formula f;
    const std::string body = write(f);
    return " " + plainText(f.equals(body));
  }
};

/// The values that a learner reads, one to a line, by the names that the worked lines give them.
std::string valueLines(const std::vector<NamedValue> &values) {
  std::string text;
  for (const NamedValue &value : values)
    if (const auto *group = std::get_if<std::vector<NamedValue>>(&value.value))
      text += valueLines(*group);
    else if (!value.latex.empty())
      text += plainText(value.latex) + std::visit(ValueText(), value.value) + "\n";
  return text;
}

/// The three pieces read on from one another.
std::string latexOf(const WorkingLine &line) {
  std::string latex = line.symbols;
  for (const std::string *piece : {&line.numbers, &line.result})
    if (!piece->empty())
      latex += " " + *piece;
  return withoutMarks(latex);
}

/// Puts the alignment mark before the first relation outside of all braces.
std::string aligned(const std::string &latex) {
  int depth = 0;
  for (std::size_t at = 0; at < latex.size(); ++at) {
    depth += latex[at] == '{' ? 1 : latex[at] == '}' ? -1 : 0;
    const bool relation =
        latex[at] == '=' || latex[at] == '<' || latex[at] == '>' || latex.compare(at, 7, "\\approx") == 0;
    if (depth == 0 && relation)
      return latex.substr(0, at) + "&" + latex.substr(at);
  }
  return "&" + latex;
}

/// Words in LaTeX: the characters that mean something there are escaped.
std::string escaped(const std::string &text) {
  std::string latex;
  for (const char c : text) {
    if (c == '\\')
      latex += "\\textbackslash{}";
    else if (c == '^' || c == '~')
      latex += std::string("\\") + c + "{}";
    else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos)
      latex += std::string("\\") + c;
    else
      latex += c;
  }
  return latex;
}

} // namespace

std::string explanationJson(const std::string &lesson, const Outcome &outcome) {
  Json working = Json::array();
  for (const WorkingLine &line : outcome.working.lines)
    working.push_back({{"id", line.id},
                       {"symbols", withoutMarks(line.symbols)},
                       {"numbers", withoutMarks(line.numbers)},
                       {"result", withoutMarks(line.result)},
                       {"text", plainText(latexOf(line))},
                       {"sentence", line.sentence}});
  const Json json{{"lesson", lesson},
                  {"case", outcome.caseName},
                  {"values", ValueJson()(outcome.values)},
                  {"working", working},
                  {"description", outcome.description}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string explanationText(const std::string &title, const Outcome &outcome) {
  std::string text = title + "\n\n";
  for (const WorkingLine &line : outcome.working.lines) {
    text += plainText(latexOf(line)) + "\n";
    if (!line.sentence.empty())
      text += "    " + line.sentence + "\n";
  }
  return text + "\n" + valueLines(outcome.values) + "\n" + outcome.description + "\n";
}

std::string explanationLatex(const std::string &title, const Outcome &outcome) {
  std::string lines;
  for (const WorkingLine &line : outcome.working.lines)
    lines += (lines.empty() ? "  " : " \\\\\n  ") + aligned(latexOf(line));
  return "\\paragraph{" + escaped(title) + "}\n\\begin{align*}\n" + lines + "\n\\end{align*}\n" +
         escaped(outcome.description) + "\n";
}

} // namespace halfspace
