#include "lessons/scene/file/label_fields.h"

#include "lessons/reading/decimal_field.h"
#include "lessons/reading/document_builder.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

static_assert(mostLabelsByHand <= maxMapKeys, "what is written can be read");

constexpr const char *atField = "at";
constexpr const char *sideField = "side";

using SideWord = std::pair<std::string_view, LabelSpot::Side>;
constexpr std::array sideWords{SideWord{"left", LabelSpot::Side::Left},
                               SideWord{"middle", LabelSpot::Side::Middle},
                               SideWord{"right", LabelSpot::Side::Right}};

std::string wordOf(LabelSpot::Side side) {
  return std::string(std::find_if(sideWords.begin(), sideWords.end(), [&](const SideWord &word) {
                       return word.second == side;
                     })->first);
}

LabelSpot::Side readSide(const DocumentNode &node, FieldReader &fields) {
  const std::string text = fields.text(sideField, wordOf(LabelSpot::Side::Middle));
  const auto word = std::find_if(sideWords.begin(), sideWords.end(),
                                 [&](const SideWord &each) { return each.first == text; });
  if (word != sideWords.end())
    return word->second;
  fields.complain(node, fields.pathOf(sideField), words("Here left, middle or right is expected."));
  return {};
}

double readOffset(const DocumentNode &node, const std::string &field, FieldReader &fields) {
  const double offset = readDecimal(node, field, fields);
  if (std::abs(offset) > mostLabelOffset)
    fields.complain(node, field,
                    words("A label is at most {limit} times the size of its type away from its mark.",
                          {{"limit", std::to_string(std::lround(mostLabelOffset))}}));
  return offset;
}

std::optional<LabelSpot> readSpot(const DocumentNode &label, FieldReader &fields) {
  const LabelSpot::Side side = readSide(label, fields);
  const DocumentNode *at = fields.optional(atField);
  if (!at)
    return {};
  const std::string field = fields.pathOf(atField);
  if (at->kind != DocumentNode::Kind::List || at->children.size() != 2) {
    fields.complain(*at, field, words("Here two numbers are expected, as [2, -1]."));
    return {};
  }
  const double right = readOffset(at->children[0], field, fields);
  const double down = readOffset(at->children[1], field, fields);
  return settled({{right, down}, side});
}

LabelByHand readLabel(const DocumentNode &node, const Scene &scene, const LabelsByHand &before,
                      FieldReader &labels) {
  FieldReader fields(node, labels.file(), labels.pathOf(shortened(node.key)));
  const std::string entry(entryOfMark(node.key));
  if (!scene.entries.find(entry))
    fields.complain(node, fields.pathOf(""),
                    words("There is no “{name}” in the scene.", {{"name", shortened(entry)}}));
  if (const auto problem = refuseLabel(before, node.key))
    fields.complain(node, fields.pathOf(""), problem->sentence);
  fields.allowOnly({atField, sideField, hiddenField});
  LabelByHand label{readSpot(node, fields), fields.truth(hiddenField, false)};
  if (fields.problem())
    labels.keep(*fields.problem());
  return label;
}

} // namespace

nlohmann::ordered_json jsonOf(const LabelsByHand &labels) {
  nlohmann::ordered_json json;
  for (const auto &[mark, label] : labels) {
    auto &fields = json[mark] = nlohmann::ordered_json::object();
    if (label.spot) {
      const LabelSpot spot = settled(*label.spot);
      fields[atField] = {spot.offset.x, spot.offset.y};
      if (spot.side != LabelSpot::Side::Middle)
        fields[sideField] = wordOf(spot.side);
    }
    if (label.isHidden)
      fields[hiddenField] = true;
  }
  return json;
}

LabelsByHand readLabels(const DocumentNode &node, const Scene &scene, FieldReader &session) {
  LabelsByHand labels;
  FieldReader fields(node, session.file(), session.pathOf(labelsField));
  if (node.kind != DocumentNode::Kind::Map)
    fields.complain(node, fields.pathOf(""), words("Here labels are expected by the ids of their marks."));
  for (const DocumentNode &child : node.children) {
    if (fields.problem())
      break;
    const LabelByHand label = readLabel(child, scene, labels, fields);
    if (label != LabelByHand())
      labels.emplace(child.key, label);
  }
  if (fields.problem())
    session.keep(*fields.problem());
  return labels;
}

} // namespace halfspace
