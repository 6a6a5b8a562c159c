#include "lessons/scene/file/session_file.h"

#include "lessons/reading/typed_number.h"
#include "lessons/scene/file/camera_reader.h"
#include "lessons/scene/file/label_fields.h"
#include "lessons/scene/file/large_meshes.h"
#include "lessons/scene/file/scene_reader.h"
#include "lessons/scene/file/scene_writer.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view formatName = "halfspace";
constexpr int highestStep = 100000;

/// Whether the text is one of ours, and of a version that this program reads.
void checkFormat(const DocumentNode &root, FieldReader &fields) {
  if (const DocumentNode *format = root.find("format"); !format || format->text != formatName)
    fields.complain(root, "format", words("This is not a Halfspace session."));
  const int version = fields.integer("version", 1, highestStep);
  if (version > sessionFileVersion)
    fields.complain(
        *root.find("version"), "version",
        words("This session was saved by a newer version of Halfspace (format {version}, this program reads "
              "up to {known}). Update the program to open it.",
              {{"version", std::to_string(version)}, {"known", std::to_string(sessionFileVersion)}}));
}

/// To a millionth: who looks sees no less, and the text is short.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json jsonOf(const glm::dvec3 &place) { return {rounded(place.x), rounded(place.y), rounded(place.z)}; }

Json jsonOf(const ChosenView &view) {
  return {{"from", jsonOf(view.view.from)},
          {"at", jsonOf(view.view.at)},
          {"height", rounded(view.view.height)},
          {"orthographic", view.orthographic}};
}

ChosenView readView(const DocumentNode &node, FieldReader &session) {
  ChosenView chosen;
  FieldReader fields(node, session.file(), "view");
  fields.allowOnly({"from", "at", "height", "orthographic"});
  readCameraView(node, "view", fields, chosen.view);
  chosen.orthographic = fields.truth("orthographic", chosen.orthographic);
  if (fields.problem())
    session.keep(*fields.problem());
  return chosen;
}

Problem unknownCoordinate(const Scene &scene, const std::string &name) {
  std::string known;
  for (const CoordinateId &id : coordinatesOf(scene))
    known += (known.empty() ? "" : ", ") + shortName(scene, id);
  return {words("“{name}” is not one of the values here: {known}.",
                {{"name", shortened(name)}, {"known", known}}),
          "", 0, shortened(name)};
}

} // namespace

std::string writeSession(const Session &session) {
  const Scene scene = withoutLargeMeshes(session.scene);
  Json json{{"format", formatName},
            {"version", sessionFileVersion},
            {"lesson", session.lesson},
            {"step", session.step},
            {"scene", jsonOf(scene)}};
  if (session.view)
    json["view"] = jsonOf(*session.view);
  if (!scene.labels.empty())
    json[labelsField] = jsonOf(scene.labels);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Session> readSession(std::string_view text, const std::string &file) {
  if (text.size() > maxSessionBytes)
    return Problem{words("The file is too large to be a session: at most {limit} MiB are read.",
                         {{"limit", std::to_string(maxSessionBytes >> 20)}}),
                   file, 0, ""};
  const auto root = parseJson(text, file, maxSessionDepth);
  if (!root)
    return root.problem();

  FieldReader fields(*root, file, "");
  checkFormat(*root, fields);
  if (!fields.problem())
    fields.allowOnly({"format", "version", "lesson", "step", "scene", "view", labelsField});
  Session session;
  session.lesson = fields.lessonId("lesson");
  session.step = fields.integer("step", 0, highestStep);
  const DocumentNode *list = fields.required("scene");
  if (const DocumentNode *view = fields.optional("view"))
    session.view = readView(*view, fields);
  if (fields.problem())
    return *fields.problem();
  auto scene = readScene(*list, file, "scene");
  if (!scene)
    return scene.problem();
  session.scene = std::move(*scene);
  if (const DocumentNode *labels = fields.optional(labelsField))
    session.scene.labels = readLabels(*labels, session.scene, fields);
  if (fields.problem())
    return *fields.problem();
  return session;
}

Result<Session> withValue(Session session, std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    return Problem{words("“{text}” sets nothing: write it as Q=11,15,8.", {{"text", shortened(assignment)}}),
                   "", 0, ""};
  const std::string name(trimmed(assignment.substr(0, equals)));
  const auto id = findCoordinate(session.scene, name);
  if (!id)
    return unknownCoordinate(session.scene, name);
  const auto numbers = partsOf(assignment.substr(equals + 1), ",");
  Object object = *findObject(session.scene, id->object);
  const int expected = numbersIn(coordinatesOf(object)[id->index].role);
  if (static_cast<int>(numbers.size()) != expected)
    return Problem{expected == 3 ? words("{name} takes three numbers, as {name}=1,2,3.", {{"name", name}})
                                 : words("{name} takes one number, as {name}=3.", {{"name", name}}),
                   "", 0, name};
  ExactVec3 &target = coordinate(object, id->index);
  for (int i = 0; i < expected; ++i) {
    const auto value = readCoordinate(plainSpelling(numbers[static_cast<std::size_t>(i)]));
    if (!value)
      return Problem{value.problem().sentence, "", 0, name};
    target[i] = *value;
  }
  if (const auto problem = refuseUnfitting(object))
    return Problem{problem->sentence, "", 0, name};
  setObject(session.scene, id->object, std::move(object));
  return session;
}

} // namespace halfspace
