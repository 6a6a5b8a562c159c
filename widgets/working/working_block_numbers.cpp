// The numbers in the lines: traced, chosen by the keys, scrubbed and typed.
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_words.h"
#include "widgets/working/working_block.h"

#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>

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

// --- traced ---------------------------------------------------------------------------------------------

void WorkingBlock::hoverNumber(std::optional<NumberPlace> number) {
  if (number == m_hoveredNumber)
    return;
  m_hoveredNumber = std::move(number);
  if (!m_hoveredNumber)
    unsetCursor();
  else
    setCursor(m_hoveredNumber->coordinate() ? Qt::SizeHorCursor : Qt::PointingHandCursor);
  update();
}

void WorkingBlock::showTip(const QPoint &at) {
  const auto place = shownNumbers().at(QPointF(at));
  const Term *number = place ? shownNumbers().numberAt(*place) : nullptr;
  if (number)
    QToolTip::showText(mapToGlobal(at), tipOf(*number).toHtmlEscaped(), this);
  else
    QToolTip::hideText();
}

void WorkingBlock::setTrace(std::optional<NumberPlace> number, std::set<std::string> lines) {
  m_tracedNumber = std::move(number);
  m_tracedLines = std::move(lines);
  update();
}

void WorkingBlock::endChoice() {
  m_chosenNumber.reset();
  tellSpoken();
  update();
}

// --- chosen by the keys ---------------------------------------------------------------------------------

bool WorkingBlock::chooseBeside(int way) {
  const std::size_t line = m_current.value_or(0);
  const std::vector<NumberPlace> shown = shownNumbers().inLine(line);
  if (shown.empty())
    return false;
  const auto chosen = m_chosenNumber ? std::find(shown.begin(), shown.end(), *m_chosenNumber) : shown.end();
  const auto last = static_cast<std::ptrdiff_t>(shown.size()) - 1;
  const std::ptrdiff_t next = chosen == shown.end()
                                  ? (way > 0 ? 0 : last)
                                  : std::clamp(chosen - shown.begin() + way, std::ptrdiff_t{0}, last);
  setCurrentLine(line);
  m_chosenNumber = shown[static_cast<std::size_t>(next)];
  if (const auto boxes = shownNumbers().boxesOf(*m_chosenNumber); !boxes.empty())
    emit reached(boxes.front().toAlignedRect());
  tellSpoken();
  return true;
}

bool WorkingBlock::useChosen() {
  if (!m_chosenNumber || !shownNumbers().lineOf(*m_chosenNumber))
    return false;
  if (m_chosenNumber->coordinate())
    openNumberField(*m_chosenNumber);
  else
    emit traceRequested(*m_chosenNumber);
  return true;
}

// --- scrubbed -------------------------------------------------------------------------------------------

void WorkingBlock::connectScrub() {
  connect(&m_scrub, &Scrub::started, this, [this] { emit scrubStarted(*m_pressedNumber->coordinate()); });
  connect(&m_scrub, &Scrub::moved, this, &WorkingBlock::scrubbed);
  connect(&m_scrub, &Scrub::ended, this, [this](bool keep) {
    m_pressedNumber.reset(); // it was no click, even if the button goes up over it
    emit scrubEnded(keep);
  });
}

void WorkingBlock::pressNumber(const NumberPlace &number, const QMouseEvent &event) {
  m_pressedNumber = number;
  m_chosenNumber.reset();
  tellSpoken();
  m_current = shownNumbers().lineOf(number); // without scrolling: the number stays under the pointer
  update();
  if (number.coordinate())
    m_scrub.press(event);
}

// --- typed ----------------------------------------------------------------------------------------------

void WorkingBlock::openNumberField(const NumberPlace &number) {
  const Term *shown = shownNumbers().numberAt(number);
  if (!shown)
    return;
  closeNumberField();
  auto *field = new NumberField(this);
  field->setAccessibleName(nameOfCoordinate(*shown));
  field->setValue(valueOf(*shown));
  connectNumberField(*field, *number.coordinate());
  m_typed = TypedNumber{number, field, {}};
  moveNumberField();
  field->show();
  field->setFocus();
  field->selectAll();
}

void WorkingBlock::connectNumberField(NumberField &field, const CoordinateSource &number) {
  connect(&field, &NumberField::valueTyped, this,
          [=, this](const Rational &value) { emit coordinateTyped(number, value); });
  connect(&field, &NumberField::stepped, this,
          [=, this](int steps) { emit coordinateStepped(number, steps); });
  connect(&field, &NumberField::scrubStarted, this, [=, this] { emit scrubStarted(number); });
  connect(&field, &NumberField::scrubbed, this, &WorkingBlock::scrubbed);
  connect(&field, &NumberField::scrubEnded, this, [this](bool keep) {
    emit scrubEnded(keep);
    followNumberField(); // it may have outlived its number
  });
  connect(&field, &NumberField::refused, this, [this, &field](const QString &sentence) {
    m_typed->refusal = sentence;
    field.setAccessibleDescription(sentence);
    placeLines(); // the sentence takes its room
  });
  connect(&field, &NumberField::textChanged, this, &WorkingBlock::moveNumberField);
  connect(&field, &NumberField::textEdited, this, &WorkingBlock::typing);
  connect(&field, &NumberField::dropped, this, &WorkingBlock::closeNumberField);
  connect(&field, &NumberField::editingFinished, this, [this] {
    if (m_typed && m_typed->refusal.isEmpty())
      closeNumberField();
  });
}

void WorkingBlock::followNumberField() {
  if (!m_typed)
    return;
  const Term *number = shownNumbers().numberAt(m_typed->place);
  if (!number) {
    if (!m_typed->field->isScrubbing()) // else it is to tell of its end, and the number may come back
      closeNumberField();
    return;
  }
  m_typed->field->setValue(valueOf(*number));
  moveNumberField();
}

void WorkingBlock::moveNumberField() {
  const auto boxes = m_typed ? shownNumbers().boxesOf(m_typed->place) : std::vector<QRectF>();
  if (boxes.empty())
    return;
  QRect box(QPoint(), sizeOf(*m_typed->field));
  box.moveCenter(boxes.front().center().toPoint());
  box.moveLeft(std::max(0, std::min(box.left(), width() - box.width())));
  m_typed->field->setGeometry(box);
}

void WorkingBlock::closeNumberField() {
  if (!m_typed)
    return;
  const TypedNumber typed = *std::exchange(m_typed, {});
  typed.field->disconnect(this);
  if (typed.field->hasFocus())
    setFocus();
  typed.field->hide();
  typed.field->deleteLater(); // its own signal may have led here
  if (!typed.refusal.isEmpty())
    placeLines();
  emit typing();
}

std::optional<TypedCoordinate> WorkingBlock::typed() const {
  const auto value = m_typed ? m_typed->field->typed() : std::nullopt;
  return value ? std::optional(TypedCoordinate{*m_typed->place.coordinate(), *value}) : std::nullopt;
}

QString WorkingBlock::enterTyped() {
  m_scrub.end(true);
  if (!m_typed)
    return {};
  QString why = m_typed->field->enter();
  if (why.isEmpty())
    closeNumberField();
  return why;
}

} // namespace halfspace
