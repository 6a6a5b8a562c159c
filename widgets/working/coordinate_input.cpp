#include "widgets/working/coordinate_input.h"

#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_words.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// The value of a number that is a coordinate.
Rational valueOf(const Term &number) {
  const Real *value = numberOf(number);
  return value && value->exact() ? value->exact()->rationalPart() : Rational(0);
}

/// As wide as its text needs it, and a little for the next letter: the neighbours are to be seen.
QSize sizeOf(const NumberField &field) {
  const QFontMetrics metrics = field.fontMetrics();
  const int width =
      metrics.horizontalAdvance(field.text()) + 2 * metrics.averageCharWidth() + metrics.height();
  return {width, field.sizeHint().height()};
}

} // namespace

CoordinateInput::CoordinateInput(QWidget &block, const BlockLayout &layout)
    : m_block(block), m_layout(layout), m_scrub(block) {
  connect(&m_scrub, &Scrub::started, this, [this] { emit scrubStarted(m_scrubbed); });
  connect(&m_scrub, &Scrub::moved, this, &CoordinateInput::scrubbed);
  connect(&m_scrub, &Scrub::ended, this, &CoordinateInput::scrubEnded);
}

void CoordinateInput::press(const CoordinateSource &number, const QMouseEvent &event) {
  m_scrubbed = number;
  m_scrub.press(event);
}

bool CoordinateInput::useKey(int key) {
  if (!isScrubbing())
    return false;
  if (key == Qt::Key_Escape)
    endScrub(false);
  return true;
}

void CoordinateInput::openField(const NumberPlace &number) {
  const Term *shown = m_layout.numbers().numberAt(number);
  if (!shown)
    return;
  closeField();
  m_place = number;
  m_field = new NumberField(&m_block);
  m_field->setAccessibleName(nameOfCoordinate(*shown));
  m_field->setValue(valueOf(*shown));
  connectField(*number.coordinate());
  placeField();
  m_field->show();
  m_field->setFocus();
  m_field->selectAll();
}

void CoordinateInput::connectField(const CoordinateSource &number) {
  connect(m_field, &NumberField::valueTyped, this,
          [=, this](const Rational &value) { emit coordinateTyped(number, value); });
  connect(m_field, &NumberField::stepped, this,
          [=, this](int steps) { emit coordinateStepped(number, steps); });
  connect(&m_field->scrub(), &Scrub::started, this, [=, this] { emit scrubStarted(number); });
  connect(&m_field->scrub(), &Scrub::moved, this, &CoordinateInput::scrubbed);
  connect(&m_field->scrub(), &Scrub::ended, this, [this](bool keep) {
    emit scrubEnded(keep);
    followLines(); // it may have outlived its number
  });
  connect(m_field, &NumberField::refused, this, &CoordinateInput::refuse);
  connect(m_field, &NumberField::textChanged, this, &CoordinateInput::placeField);
  connect(m_field, &NumberField::textEdited, this, &CoordinateInput::typing);
  connect(m_field, &NumberField::dropped, this, &CoordinateInput::closeField);
  connect(m_field, &NumberField::editingFinished, this, [this] {
    if (!m_refusal)
      closeField();
  });
}

void CoordinateInput::refuse(const QString &sentence) {
  m_refusal = sentence.isEmpty() ? std::nullopt : std::optional(Refusal{m_place->line, sentence});
  m_field->setAccessibleDescription(sentence);
  emit refusalChanged();
}

void CoordinateInput::followLines() {
  if (!m_field)
    return;
  const Term *number = m_layout.numbers().numberAt(*m_place);
  if (!number) {
    if (!m_field->scrub().isScrubbing()) // else it is to tell of its end, and the number may come back
      closeField();
    return;
  }
  m_field->setValue(valueOf(*number));
  placeField();
}

void CoordinateInput::placeField() {
  const auto boxes = m_layout.numbers().boxesOf(*m_place);
  if (boxes.empty())
    return;
  QRect box(QPoint(), sizeOf(*m_field));
  box.moveCenter(boxes.front().center().toPoint());
  box.moveLeft(std::max(0, std::min(box.left(), m_block.width() - box.width())));
  m_field->setGeometry(box);
}

void CoordinateInput::closeField() {
  if (!m_field)
    return;
  NumberField &field = *std::exchange(m_field, nullptr);
  const bool wasRefused = std::exchange(m_refusal, {}).has_value();
  field.disconnect(this);
  field.scrub().disconnect(this);
  if (field.hasFocus())
    m_block.setFocus();
  field.hide();
  field.deleteLater(); // its own signal may have led here
  if (wasRefused)
    emit refusalChanged();
  emit typing();
}

std::optional<TypedCoordinate> CoordinateInput::typed() const {
  const auto value = m_field ? m_field->typed() : std::nullopt;
  return value ? std::optional(TypedCoordinate{*m_place->coordinate(), *value}) : std::nullopt;
}

QString CoordinateInput::enter() {
  endScrub(true);
  if (!m_field)
    return {};
  QString why = m_field->enter();
  if (why.isEmpty())
    closeField();
  return why;
}

} // namespace halfspace
