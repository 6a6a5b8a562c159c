#include "lessons/scene/file/explain_formats.h"

#include "eval/answer.h"
#include "lessons/construction/line_text.h"
#include "lessons/scene/file/scene_writer.h"
#include "lessons/term/latex_words.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/spoken.h"
#include "lessons/term/written.h"
#include "lessons/xml_text.h"

#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

/// Writes a value as the eval format has it.
struct ValueWriter {
  Answer &answer;
  const std::string &name;

  void operator()(const Surd &number) const { answer.number(name, number); }
  void operator()(const std::vector<Surd> &list) const { answer.numbers(name, list); }
  void operator()(const Word &word) const { answer.word(name, word.name); }
  void operator()(int index) const { answer.index(name, static_cast<std::size_t>(index)); }
  void operator()(const std::vector<NamedValue> &group) const {
    answer.beginGroup(name);
    for (const NamedValue &each : group)
      std::visit(ValueWriter{answer, each.name}, each.value);
    answer.endGroup();
  }
};

Json valuesJson(const std::vector<NamedValue> &values) {
  std::string fields;
  Answer answer(fields);
  for (const NamedValue &each : values)
    std::visit(ValueWriter{answer, each.name}, each.value);
  return Json::parse("{" + fields + "}");
}

/// ` = 10`, ` ≈ 3.16228`, `: positive`: what follows a value's name.
std::string valueText(const Value &value) {
  if (const auto term = termOf(value))
    return relatedText(*term);
  const auto *word = std::get_if<Word>(&value);
  return word ? ": " + word->read : "";
}

/// The values that a learner reads, one to a line, by the names that the worked lines give them.
std::string valueLines(const std::vector<NamedValue> &values) {
  std::string text;
  for (const NamedValue &value : values)
    if (const auto *group = std::get_if<std::vector<NamedValue>>(&value.value))
      text += valueLines(*group);
    else if (!std::holds_alternative<std::monostate>(value.label))
      text += readName(value) + valueText(value.value) + "\n";
  return text;
}

Json workingJson(const EvaluatedEntry &entry) {
  Json working = Json::array();
  for (const std::string &id : entry.outcome->explanation->ids()) {
    const WorkingLine &line = *entry.outcome->explanation->find(id);
    working.push_back({{"id", line.id},
                       {"latex", latexOf(line)},
                       {"symbols", latexOf(line, LinePiece::Symbols)},
                       {"numbers", latexOf(line, LinePiece::Numbers)},
                       {"result", latexOf(line, LinePiece::Result)},
                       {"text", plainText(line)},
                       {"spoken", spoken(line)},
                       {"sentence", line.sentence}});
  }
  return working;
}

/// What is told of a construction.
Json outcomeJson(const EvaluatedEntry &entry) {
  const Outcome &outcome = *entry.outcome;
  Json objects = Json::object();
  for (const MadeObject &made : outcome.objects)
    objects[made.name] = jsonOf(made.object);
  return {{"case", outcome.told->name},
          {"values", valuesJson(*outcome.values)},
          {"objects", objects},
          {"working", workingJson(entry)},
          {"description", outcome.told->description}};
}

Json outcomesJson(const Scene &scene, const Evaluation &evaluation) {
  Json outcomes = Json::array();
  for (const Entry &entry : scene.entries)
    if (const auto *use = std::get_if<ConstructionUse>(&entry.content))
      if (const EvaluatedEntry *evaluated = evaluation.find(entry.name)) {
        Json json{{"entry", entry.name}, {"construction", use->id}, {"of", rolesJson(*use)}};
        json.update(outcomeJson(*evaluated));
        outcomes.push_back(std::move(json));
      }
  return outcomes;
}

std::vector<const EvaluatedEntry *> constructionsOf(const Evaluation &evaluation) {
  std::vector<const EvaluatedEntry *> constructions;
  for (const EvaluatedEntry &entry : evaluation.entries)
    if (entry.isConstruction())
      constructions.push_back(&entry);
  return constructions;
}

/// Where bound points are, one to a line; or why one is nowhere.
std::string placesText(const Evaluation &evaluation) {
  std::string text;
  for (const EvaluatedEntry &entry : evaluation.entries)
    if (!entry.isConstruction())
      text += entry.missing.empty() ? valueLines(*entry.outcome->values) : entry.missing + "\n";
  return text;
}

std::vector<ToldLine> linesOf(const EvaluatedEntry &entry) {
  std::vector<ToldLine> lines;
  for (const std::string &id : entry.outcome->explanation->ids())
    lines.push_back({entry.outcome->explanation->find(id)});
  return lines;
}

std::string textOf(const EvaluatedEntry &entry) {
  std::string text = workingText(linesOf(entry), DocumentFormat::PlainText);
  for (const std::string &part :
       {valueLines(*entry.outcome->values), entry.outcome->told->description + "\n"})
    if (!part.empty())
      text += (text.empty() ? "" : "\n") + part;
  return text;
}

std::string latexOf(const EvaluatedEntry &entry) {
  return workingText(linesOf(entry), DocumentFormat::Latex) + latexWords(entry.outcome->told->description) +
         "\n";
}

std::string mathMlOf(const EvaluatedEntry &entry) {
  return workingText(linesOf(entry), DocumentFormat::MathMl) +
         xmlElement("p", escapedForXml(entry.outcome->told->description)) + "\n";
}

} // namespace

std::string explanationJson(const std::string &lesson, const Scene &scene, const Evaluation &evaluation) {
  Json json{{"lesson", lesson}};
  if (const EvaluatedEntry *last = evaluation.lastConstruction())
    json.update(outcomeJson(*last));
  json["scene"] = jsonOf(scene);
  json["outcomes"] = outcomesJson(scene, evaluation);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string explanationText(const std::string &title, const Evaluation &evaluation) {
  const auto entries = constructionsOf(evaluation);
  std::string text = title.empty() ? "" : title + "\n";
  const auto parted = [&] { return text.empty() ? "" : "\n"; };
  if (const std::string places = placesText(evaluation); !places.empty())
    text += parted() + places;
  for (const EvaluatedEntry *entry : entries)
    text += parted() + (entries.size() > 1 ? entry->name + ":\n\n" : "") + textOf(*entry);
  return text;
}

std::string explanationLatex(const std::string &title, const Evaluation &evaluation) {
  const auto entries = constructionsOf(evaluation);
  std::string latex = title.empty() ? "" : "\\paragraph{" + latexWords(title) + "}\n";
  for (const EvaluatedEntry *entry : entries)
    latex +=
        (entries.size() > 1 ? "\\subparagraph{" + latexWords(entry->name) + "}\n" : "") + latexOf(*entry);
  return latex;
}

std::string explanationMathMl(const std::string &title, const Evaluation &evaluation) {
  const auto entries = constructionsOf(evaluation);
  std::string html = title.empty() ? "" : xmlElement("h2", escapedForXml(title)) + "\n";
  for (const EvaluatedEntry *entry : entries)
    html +=
        (entries.size() > 1 ? xmlElement("h3", escapedForXml(entry->name)) + "\n" : "") + mathMlOf(*entry);
  return xmlElement("section", "\n" + html) + "\n";
}

} // namespace halfspace
