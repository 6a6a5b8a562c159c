#include "widgets/numbers/coordinate_row.h"

#include "lessons/object/kinds/number.h"
#include "lessons/term/plain_text.h"
#include "widgets/formula/term_formula.h"
#include "widgets/mark_ink.h"
#include "widgets/numbers/number_field.h"

#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>

namespace halfspace {
namespace {

/// A slider's steps from one bound to the other, and how many of them the value is above the lower one.
struct SliderRange {
  int steps;
  int position;
};

/// More steps than this cannot be told apart on a slider.
constexpr int mostSliderSteps = 10000;

/// Of a number with bounds and a step; nothing for what has none.
std::optional<SliderRange> rangeOf(const Object &object) {
  const auto number = objectAs<NumberObject>(object);
  if (!number || number->step == 0)
    return {};
  const auto stepsTo = [&](const Rational &end) {
    return static_cast<int>(
        std::min(toDouble(Rational((end - number->from) / number->step)), double(mostSliderSteps)));
  };
  return SliderRange{stepsTo(number->to), stepsTo(number->value)};
}

int numbersOf(const Object &object, const CoordinateId &id) {
  return numbersIn(coordinatesOf(object)[id.index].role);
}

} // namespace

CoordinateRow::CoordinateRow(SessionModel &model, CoordinateEditor &editor, const Typesetter &typesetter,
                             CoordinateId id)
    : m_model(model), m_editor(editor), m_id(std::move(id)), m_letter(currentLetter(m_id)),
      m_name(fullName(model.session().scene, m_id)), m_label(new MathLabel(typesetter)) {
  m_label->setFormula(formulaOf(m_letter), QString::fromStdString(plainText(m_letter)));
  addFields();
  if (rangeOf(object()) && m_id.index == 0)
    addSlider();
}

const Object &CoordinateRow::object() const { return *findObject(m_model.session().scene, m_id.object); }

const Symbol &CoordinateRow::currentLetter(const CoordinateId &id) const {
  return m_model.evaluation().find(id.object)->own->letters[id.index];
}

bool CoordinateRow::isMadeFor(const CoordinateId &id) const {
  return m_id == id && static_cast<int>(m_fields.size()) == numbersOf(object(), id) &&
         m_letter == currentLetter(id);
}

void CoordinateRow::addFields() {
  static const char *const axes[3] = {"x", "y", "z"};
  const int numbers = numbersOf(object(), m_id);
  for (int axis = 0; axis < numbers; ++axis) {
    auto *field = new NumberField;
    field->setAccessibleName(QString::fromStdString(m_name) + (numbers > 1 ? QString(" ") + axes[axis] : ""));
    connectField(*field, {m_id, axis});
    m_fields.push_back(field);
  }
}

void CoordinateRow::connectField(NumberField &field, const CoordinateNumber &number) {
  connect(&field, &NumberField::valueTyped, this,
          [=, this](const Rational &value) { m_editor.change(number, value); });
  connect(&field, &NumberField::stepped, this, [=, this](int steps) { m_editor.step(number, steps); });
  connect(&field, &NumberField::textEdited, this, &CoordinateRow::typing);
  connect(&field, &NumberField::dropped, this, &CoordinateRow::typing);
  connect(&field, &NumberField::refused, this, &CoordinateRow::refused);
  connect(&field.scrub(), &Scrub::started, this, [=, this] { m_editor.beginScrub(number); });
  connect(&field.scrub(), &Scrub::moved, this, [this](int steps) { m_editor.scrub(steps); });
  connect(&field.scrub(), &Scrub::ended, this, [this](bool keep) { m_editor.endScrub(keep); });
}

void CoordinateRow::addSlider() {
  m_slider = new QSlider(Qt::Horizontal);
  m_slider->setAccessibleName(QString::fromStdString(m_name));
  connect(m_slider, &QSlider::sliderPressed, this, [this] {
    m_sliderStart = m_slider->value();
    m_editor.beginScrub({m_id, 0});
  });
  connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
    if (m_slider->isSliderDown())
      m_editor.scrub(position - m_sliderStart);
    else if (const auto range = rangeOf(object()))
      m_editor.step({m_id, 0}, position - range->position);
  });
  connect(m_slider, &QSlider::sliderReleased, this, [this] { m_editor.endScrub(true); });
}

void CoordinateRow::showOnSlider() {
  const auto range = rangeOf(object());
  if (!range || m_slider->isSliderDown())
    return;
  const QSignalBlocker silent(m_slider);
  m_slider->setRange(0, range->steps);
  m_slider->setValue(range->position);
}

void CoordinateRow::showNumbers() {
  const ExactVec3 &value = coordinate(object(), m_id.index);
  for (std::size_t axis = 0; axis < m_fields.size(); ++axis)
    m_fields[axis]->setValue(value[static_cast<int>(axis)], lookOf(value));
  if (m_slider)
    showOnSlider();
}

void CoordinateRow::setTheme(const Theme &theme) {
  const QColor ink = markInk(m_model, theme)(QString::fromStdString(m_name));
  m_label->setInkOf([ink](const QString &) { return ink; });
}

std::optional<ChangeObject> CoordinateRow::typed() const {
  for (std::size_t axis = 0; axis < m_fields.size(); ++axis)
    if (const auto value = m_fields[axis]->typed())
      return m_editor.editOf({m_id, static_cast<int>(axis)}, *value);
  return {};
}

QString CoordinateRow::enterTyped() {
  QString refused;
  for (NumberField *field : m_fields)
    if (const QString why = field->enter(); refused.isEmpty())
      refused = why;
  return refused;
}

void CoordinateRow::dropTyped() {
  for (NumberField *field : m_fields)
    field->drop();
}

} // namespace halfspace
