#include "widgets/numbers/coordinate_editor.h"

#include "lessons/object/kinds/number.h"
#include "lessons/reading/typed_number.h"
#include "lessons/scene/change_words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// A number may say in which steps it goes.
Rational stepOfNumber(const Object &object, const Rational &otherwise) {
  const auto number = objectAs<NumberObject>(object);
  return number && number->step > 0 ? number->step : otherwise;
}

} // namespace

void CoordinateEditor::change(const CoordinateNumber &number, const Rational &value) {
  if (const auto edit = editOf(number, value))
    m_model.history().edit(*edit, nameOfChange(number));
}

void CoordinateEditor::step(const CoordinateNumber &number, int steps) {
  change(number, valueOf(number) + stepOf(number.id) * steps);
}

void CoordinateEditor::beginScrub(const CoordinateNumber &number) {
  m_scrubbed = number;
  m_scrubStart = valueOf(number);
  m_scrubStep = stepOf(number.id);
  m_gesture = m_model.history().beginGesture(nameOfChange(number));
}

void CoordinateEditor::scrub(int steps) {
  if (!m_model.history().isHeldBy(m_gesture))
    return; // another gesture has begun, or another lesson was opened
  if (const auto edit = editOf(m_scrubbed, m_scrubStart + m_scrubStep * steps))
    m_model.history().moveGesture(m_gesture, *edit);
}

void CoordinateEditor::endScrub(bool keep) {
  if (keep)
    m_model.history().endGesture(m_gesture);
  else
    m_model.history().cancelGesture(m_gesture);
}

Rational CoordinateEditor::valueOf(const CoordinateNumber &number) const {
  const Object *object = findObject(m_model.session().scene, number.id.object);
  return object ? coordinate(*object, number.id.index)[number.axis] : Rational(0);
}

std::optional<ChangeObject> CoordinateEditor::editOf(const CoordinateNumber &number,
                                                     const Rational &value) const {
  const Object *object = findObject(m_model.session().scene, number.id.object);
  if (!object || refuseCoordinate(value))
    return {};
  ChangeObject edit{number.id.object, *object};
  coordinate(edit.value, number.id.index)[number.axis] = value;
  return edit;
}

Rational CoordinateEditor::stepOf(const CoordinateId &id) const {
  const Object *object = findObject(m_model.session().scene, id.object);
  if (!object)
    return m_model.snapping().step;
  switch (coordinatesOf(*object)[id.index].role) {
  case CoordinateRole::Position:
  case CoordinateRole::Length:
    return m_model.snapping().step * m_model.stage().unit();
  case CoordinateRole::Number:
    return stepOfNumber(*object, m_model.snapping().step);
  case CoordinateRole::Direction:
    break;
  }
  const ExactVec3 &direction = coordinate(*object, id.index);
  const Rational longest = std::max({abs(direction.x), abs(direction.y), abs(direction.z)});
  return m_model.snapping().step * powerOfTen(suitingExponent(toDouble(longest)));
}

QString CoordinateEditor::nameOfChange(const CoordinateNumber &number) const {
  return QString::fromStdString(wordsForChanging(m_model.session().scene, number.id));
}

} // namespace halfspace
