#include "lessons/scene/change_words.h"

#include "lessons/object/kind.h"
#include "lessons/scene/scene_letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// An object of a scene with its letters; nothing where there is none of this name.
std::optional<Given<Object>> givenOf(const Scene &scene, const std::string &name) {
  const Object *object = findObject(scene, name);
  return object ? std::optional(SceneLetters(scene).given(name, *object)) : std::nullopt;
}

/// Whether the object's own letter stands in the picture. The letters of a ray's or a triangle's coordinates
/// are names enough.
bool showsItsLetter(const Given<Object> &given) {
  const std::vector<Mark> marks = given.object.kind().draw(given);
  return std::any_of(marks.begin(), marks.end(), [&](const Mark &mark) {
    return baseOf(mark).id == given.id && !baseOf(mark).label.empty();
  });
}

/// “P₀ of E”, “Q”
std::string nameOf(const Given<Object> &given, std::size_t index) {
  const Symbol &letter = given.letters[index];
  const bool saysWhose =
      coordinatesOf(given.object)[index].goesByObject() || !letter.owner.empty() || !showsItsLetter(given);
  if (saysWhose)
    return plainText(letter);
  return words("{coordinate} of {object}",
               {{"coordinate", plainText(letter)}, {"object", plainText(given.symbol)}});
}

std::string wordsToMove(const std::string &name) { return words("Move {name}", {{"name", name}}); }

} // namespace

std::string wordsForMoving(const Scene &scene, const Handle &handle) {
  const auto given = givenOf(scene, handle.object);
  if (!given)
    return {};
  const std::string object = plainText(given->symbol);
  switch (handle.motion) {
  case Handle::Motion::Coordinate:
  case Handle::Motion::Length:
  case Handle::Motion::OnHost:
    return wordsForChanging(scene, {handle.object, handle.coordinate});
  case Handle::Motion::AlongNormal:
    return words("Slide {object} along its normal", {{"object", object}});
  case Handle::Motion::Whole:
    break;
  }
  return words("Move {object} as a whole", {{"object", object}});
}

std::string wordsForChanging(const Scene &scene, const CoordinateId &id) {
  const auto given = givenOf(scene, id.object);
  if (!given || id.index >= given->letters.size())
    return {};
  if (given->object.kind().binding)
    return wordsToMove(plainText(given->symbol)); // its freedoms have no names that are seen
  switch (coordinatesOf(given->object)[id.index].role) {
  case CoordinateRole::Position:
    return wordsToMove(nameOf(*given, id.index));
  case CoordinateRole::Direction:
    return words("Move the tip of {name}", {{"name", plainText(given->letters[id.index])}});
  case CoordinateRole::Length:
  case CoordinateRole::Number:
    break;
  }
  return words("Change {name}", {{"name", nameOf(*given, id.index)}});
}

std::string wordsForLabel(const Scene &scene, const ChangeLabel &change) {
  const LabelByHand after = change.label.value_or(LabelByHand());
  if (after.isHidden)
    return words("Hide a label");
  if (isLabelHidden(scene.labels, change.mark))
    return words("Show a label");
  return after.spot ? words("Move a label") : words("Put a label back");
}

} // namespace halfspace
