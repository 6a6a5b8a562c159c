#include "lessons/lesson/condition.h"

#include "lessons/reading/document.h"
#include "lessons/reading/value_name.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

using Relation = Condition::Relation;

struct RelationSign {
  std::string_view sign;
  Relation relation;
};

/// The longer signs first, so that `<=` is not read as `<`.
constexpr std::array relationSigns{RelationSign{"!=", Relation::NotEqual},
                                   RelationSign{"<=", Relation::LessOrEqual},
                                   RelationSign{">=", Relation::GreaterOrEqual},
                                   RelationSign{"=", Relation::Equal},
                                   RelationSign{"<", Relation::Less},
                                   RelationSign{">", Relation::Greater}};

bool isOrder(Relation relation) { return relation != Relation::Equal && relation != Relation::NotEqual; }

Problem notAComparison(std::string_view text) {
  return {words("“{text}” is not a comparison: write it as side = negative, or t < 0, with and between two.",
                {{"text", shortened(text)}}),
          "", 0, ""};
}

Result<Condition> parseComparison(std::string_view text) {
  const auto at = text.find_first_of("=<>!");
  if (at == std::string_view::npos)
    return notAComparison(text);
  for (const RelationSign &known : relationSigns) {
    if (text.substr(at, known.sign.size()) != known.sign)
      continue;
    Condition condition{std::string(trimmed(text.substr(0, at))), known.relation,
                        std::string(trimmed(text.substr(at + known.sign.size())))};
    const bool number = parseRational(condition.against).has_value();
    if (!isValueName(condition.value) || (!number && !isValueName(condition.against)))
      return notAComparison(text);
    if (isOrder(condition.relation) && !number)
      return Problem{
          words("“{text}” orders a word: < and > compare a value with a number, not with a word or another "
                "value.",
                {{"text", shortened(text)}}),
          "", 0, ""};
    return condition;
  }
  return notAComparison(text);
}

constexpr std::string_view joint = " and ";

Result<Conditions> parseComparisons(std::string_view text) {
  Conditions conditions;
  while (true) {
    const auto end = text.find(joint);
    auto condition = parseComparison(trimmed(text.substr(0, end)));
    if (!condition)
      return condition.problem();
    conditions.push_back(std::move(*condition));
    if (end == std::string_view::npos)
      return conditions;
    text.remove_prefix(end + joint.size());
  }
}

/// The text with a point in the place of each comma between two digits.
std::string withDecimalPoints(std::string text) {
  const auto isDigit = [&](std::size_t at) { return text[at] >= '0' && text[at] <= '9'; };
  for (std::size_t at = 1; at + 1 < text.size(); ++at)
    if (text[at] == ',' && isDigit(at - 1) && isDigit(at + 1))
      text[at] = '.';
  return text;
}

/// Conditions as programming languages and books write them, in the signs that are read here.
std::string inOurSigns(std::string_view text) {
  struct Sign {
    std::string_view foreign;
    std::string_view ours;
  };
  constexpr std::array signs{Sign{"==", "="},  Sign{"=<", "<="},       Sign{"=>", ">="},
                             Sign{"<>", "!="}, Sign{"≤", "<="},        Sign{"≥", ">="},
                             Sign{"≠", "!="},  Sign{" AND ", " and "}, Sign{"&&", " and "}};
  std::string meant(text);
  for (const Sign &sign : signs)
    meant = replacedAll(meant, sign.foreign, sign.ours);
  while (meant.find("  ") != std::string::npos)
    meant = replacedAll(meant, "  ", " ");
  return withDecimalPoints(meant);
}

/// A value by its name among several. A number of a list has no name that a learner reads.
std::optional<NamedValue> findIn(const std::vector<NamedValue> &values, std::string_view name) {
  const auto dot = name.find('.');
  const std::string_view head = name.substr(0, dot);
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const auto &each) { return each.name == head; });
  if (found == values.end())
    return {};
  if (dot == std::string_view::npos)
    return *found;
  const std::string_view rest = name.substr(dot + 1);
  if (const auto *group = std::get_if<std::vector<NamedValue>>(&found->value))
    return findIn(*group, rest);
  const auto *list = std::get_if<std::vector<Surd>>(&found->value);
  const auto index = componentIndex(rest);
  if (!list || !index || *index >= list->size())
    return {};
  return NamedValue{std::string(name), {}, (*list)[*index]};
}

constexpr std::string_view caseName = "case";

std::optional<NamedValue> findOf(const EvaluatedEntry &entry, std::string_view name) {
  if (name == caseName && (entry.isConstruction() || !entry.missing.empty()))
    return NamedValue{std::string(name), {}, Word{entry.outcome->told->name, entry.outcome->told->name}};
  return findIn(*entry.outcome->values, name);
}

bool holdsForSign(Relation relation, int sign) {
  switch (relation) {
  case Relation::Equal:
    return sign == 0;
  case Relation::NotEqual:
    return sign != 0;
  case Relation::Less:
    return sign < 0;
  case Relation::LessOrEqual:
    return sign <= 0;
  case Relation::Greater:
    return sign > 0;
  case Relation::GreaterOrEqual:
    return sign >= 0;
  }
  return false;
}

/// Compares a value with what stands on the right; nothing for lists and groups, which do not compare.
struct Comparison {
  const Condition &condition;

  bool operator()(const Surd &number) const {
    const auto against = parseRational(condition.against);
    return against && holdsForSign(condition.relation, (number + Rational(-*against)).sign());
  }
  bool operator()(int number) const { return (*this)(Surd(number)); }
  bool operator()(const Word &word) const {
    return !isOrder(condition.relation) &&
           (word.name == condition.against) == (condition.relation == Relation::Equal);
  }
  bool operator()(const std::vector<Surd> &) const { return false; }
  bool operator()(const std::vector<NamedValue> &) const { return false; }
};

} // namespace

std::optional<std::size_t> componentIndex(std::string_view name) {
  constexpr std::string_view letters = "xyz";
  constexpr std::size_t mostDigits = 2;
  if (const auto letter = letters.find(name); name.size() == 1 && letter != std::string_view::npos)
    return letter;
  const bool isIndex = !name.empty() && name.size() <= mostDigits &&
                       (name.size() == 1 || name.front() != '0') &&
                       name.find_first_not_of("0123456789") == std::string_view::npos;
  return isIndex ? std::optional<std::size_t>(std::stoul(std::string(name))) : std::nullopt;
}

Result<Conditions> parseConditions(std::string_view text) {
  auto conditions = parseComparisons(text);
  if (conditions)
    return conditions;
  const std::string meant = inOurSigns(text);
  Problem problem = conditions.problem();
  if (meant != text && parseComparisons(meant))
    problem.sentence += " " + words("Perhaps “{guess}” is meant.", {{"guess", shortened(meant)}});
  return problem;
}

std::string toText(const Conditions &conditions) {
  std::string text;
  for (const Condition &condition : conditions) {
    const auto sign = std::find_if(relationSigns.begin(), relationSigns.end(), [&](const RelationSign &each) {
      return each.relation == condition.relation;
    });
    text += (text.empty() ? "" : std::string(joint)) + condition.value + " " + std::string(sign->sign) + " " +
            condition.against;
  }
  return text;
}

std::optional<NamedValue> findNamedValue(const Evaluation &evaluation, std::string_view name) {
  const QualifiedName ofEntry = qualified(name);
  if (const EvaluatedEntry *entry = evaluation.find(ofEntry.entry))
    return findOf(*entry, ofEntry.own);
  if (name == caseName) {
    const EvaluatedEntry *last = evaluation.lastConstruction();
    return last ? findOf(*last, name) : std::nullopt;
  }
  std::optional<NamedValue> found;
  for (const EvaluatedEntry &entry : evaluation.entries)
    if (auto value = findIn(*entry.outcome->values, name)) {
      if (found)
        return {}; // it must say whose
      found = std::move(value);
    }
  return found;
}

std::optional<Value> findValue(const Evaluation &evaluation, std::string_view name) {
  auto found = findNamedValue(evaluation, name);
  return found ? std::optional(std::move(found->value)) : std::nullopt;
}

bool holds(const Condition &condition, const Evaluation &evaluation) {
  const auto value = findValue(evaluation, condition.value);
  return value && std::visit(Comparison{condition}, *value);
}

std::string rightChoice(const Prediction &prediction, const Evaluation &evaluation) {
  const auto fits = [&](const Prediction::Choice &choice) {
    return holds({prediction.value, Condition::Relation::Equal, choice.word}, evaluation);
  };
  const auto choice = std::find_if(prediction.choices.begin(), prediction.choices.end(), fits);
  if (choice != prediction.choices.end())
    return choice->word;
  const bool isCovered = std::any_of(prediction.choices.begin(), prediction.choices.end(),
                                     [](const Prediction::Choice &each) { return each.word == otherwise; });
  return isCovered ? otherwise : std::string();
}

bool isDone(const Task &task, const Evaluation &evaluation) {
  return std::all_of(task.conditions.begin(), task.conditions.end(),
                     [&](const Condition &condition) { return holds(condition, evaluation); });
}

} // namespace halfspace
