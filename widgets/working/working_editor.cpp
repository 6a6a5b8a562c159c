#include "widgets/working/working_editor.h"

namespace halfspace {

WorkingEditor::WorkingEditor(SessionModel &model, StepWorking &working)
    : QObject(&working), m_model(model), m_working(working), m_editor(model) {
  const StepCoordinates &wanted = working.coordinates();
  connect(&wanted, &StepCoordinates::coordinateTyped, this,
          [this](const CoordinateSource &source, const Rational &value) {
            if (const auto number = numberOf(source))
              m_editor.change(*number, value);
          });
  connect(&wanted, &StepCoordinates::coordinateStepped, this,
          [this](const CoordinateSource &source, int steps) {
            if (const auto number = numberOf(source))
              m_editor.step(*number, steps);
          });
  connect(&wanted, &StepCoordinates::scrubStarted, this, [this](const CoordinateSource &source) {
    if (const auto number = numberOf(source))
      m_editor.beginScrub(*number);
  });
  connect(&wanted, &StepCoordinates::scrubbed, this, [this](int steps) { m_editor.scrub(steps); });
  connect(&wanted, &StepCoordinates::scrubEnded, this, [this](bool keep) { m_editor.endScrub(keep); });
}

std::optional<ChangeObject> WorkingEditor::typedChange() const {
  const auto typed = m_working.coordinates().typed();
  const auto number = typed ? numberOf(typed->number) : std::nullopt;
  return number ? m_editor.editOf(*number, typed->value) : std::nullopt;
}

std::optional<CoordinateNumber> WorkingEditor::numberOf(const CoordinateSource &source) const {
  const auto id = coordinateOf(m_model.session().scene, source);
  return id ? std::optional(CoordinateNumber{*id, source.component.value_or(0)}) : std::nullopt;
}

} // namespace halfspace
