// The numbers in the lines: traced, chosen by the keys, scrubbed and typed.
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_words.h"
#include "widgets/working/working_panel.h"

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

void WorkingPanel::hoverNumber(std::optional<NumberPlace> number) {
  if (number == m_hoveredNumber)
    return;
  m_hoveredNumber = std::move(number);
  if (!m_hoveredNumber)
    viewport()->unsetCursor();
  else
    viewport()->setCursor(m_hoveredNumber->coordinate() ? Qt::SizeHorCursor : Qt::PointingHandCursor);
  viewport()->update();
}

void WorkingPanel::showTip(const QPoint &at) {
  const auto place = shownNumbers().at(QPointF(at) + scrolled());
  const Term *number = place ? shownNumbers().numberAt(*place) : nullptr;
  if (number)
    QToolTip::showText(viewport()->mapToGlobal(at), tipOf(*number).toHtmlEscaped(), viewport());
  else
    QToolTip::hideText();
}

void WorkingPanel::trace(const NumberPlace &number) {
  m_tracedNumber = number;
  followNumbers();
  viewport()->update();
}

void WorkingPanel::endTrace() {
  m_tracedNumber.reset();
  m_chosenNumber.reset();
  updateAccessibleText();
  followNumbers();
  viewport()->update();
}

void WorkingPanel::followNumbers() {
  followNumberField();
  const Term *number = m_tracedNumber ? shownNumbers().numberAt(*m_tracedNumber) : nullptr;
  Provenance traced = number ? provenanceOf(*number, m_tracedNumber->line, wholeWorking()) : Provenance();
  if (traced == m_traced)
    return;
  m_traced = std::move(traced);
  viewport()->update();
  emit traceChanged();
}

Working WorkingPanel::wholeWorking() const { return m_wholeWorking ? m_wholeWorking() : m_working; }

// --- chosen by the keys ---------------------------------------------------------------------------------

bool WorkingPanel::chooseBeside(int way) {
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
    scrollTo(boxes.front());
  updateAccessibleText();
  return true;
}

bool WorkingPanel::useChosen() {
  if (!m_chosenNumber || !shownNumbers().lineOf(*m_chosenNumber))
    return false;
  if (m_chosenNumber->coordinate())
    openNumberField(*m_chosenNumber);
  else
    trace(*m_chosenNumber);
  return true;
}

// --- scrubbed -------------------------------------------------------------------------------------------

void WorkingPanel::connectScrub() {
  connect(&m_scrub, &Scrub::started, this, [this] { emit scrubStarted(*m_pressedNumber->coordinate()); });
  connect(&m_scrub, &Scrub::moved, this, &WorkingPanel::scrubbed);
  connect(&m_scrub, &Scrub::ended, this, [this](bool keep) {
    m_pressedNumber.reset(); // it was no click, even if the button goes up over it
    emit scrubEnded(keep);
  });
}

void WorkingPanel::pressNumber(const NumberPlace &number, const QMouseEvent &event) {
  m_pressedNumber = number;
  m_chosenNumber.reset();
  updateAccessibleText();
  m_current = shownNumbers().lineOf(number); // without scrolling: the number stays under the pointer
  viewport()->update();
  if (number.coordinate())
    m_scrub.press(event);
}

// --- typed ----------------------------------------------------------------------------------------------

void WorkingPanel::openNumberField(const NumberPlace &number) {
  const Term *shown = shownNumbers().numberAt(number);
  if (!shown)
    return;
  closeNumberField();
  auto *field = new NumberField(viewport());
  field->setAccessibleName(nameOfCoordinate(*shown));
  field->setValue(valueOf(*shown));
  connectNumberField(*field, *number.coordinate());
  m_typed = TypedNumber{number, field, {}};
  moveNumberField();
  field->show();
  field->setFocus();
  field->selectAll();
}

void WorkingPanel::connectNumberField(NumberField &field, const CoordinateSource &number) {
  connect(&field, &NumberField::valueTyped, this,
          [=, this](const Rational &value) { emit coordinateTyped(number, value); });
  connect(&field, &NumberField::stepped, this,
          [=, this](int steps) { emit coordinateStepped(number, steps); });
  connect(&field, &NumberField::scrubStarted, this, [=, this] { emit scrubStarted(number); });
  connect(&field, &NumberField::scrubbed, this, &WorkingPanel::scrubbed);
  connect(&field, &NumberField::scrubEnded, this, [this](bool keep) {
    emit scrubEnded(keep);
    followNumberField(); // it may have outlived its number
  });
  connect(&field, &NumberField::refused, this, [this, &field](const QString &sentence) {
    m_typed->refusal = sentence;
    field.setAccessibleDescription(sentence);
    placeLines(); // the sentence takes its room
  });
  connect(&field, &NumberField::textChanged, this, &WorkingPanel::moveNumberField);
  connect(&field, &NumberField::dropped, this, &WorkingPanel::closeNumberField);
  connect(&field, &NumberField::editingFinished, this, [this] {
    if (m_typed && m_typed->refusal.isEmpty())
      closeNumberField();
  });
}

void WorkingPanel::followNumberField() {
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

void WorkingPanel::moveNumberField() {
  const auto boxes = m_typed ? shownNumbers().boxesOf(m_typed->place) : std::vector<QRectF>();
  if (boxes.empty())
    return;
  QRect box(QPoint(), sizeOf(*m_typed->field));
  box.moveCenter(boxes.front().translated(-scrolled()).center().toPoint());
  box.moveLeft(std::max(0, std::min(box.left(), viewport()->width() - box.width())));
  m_typed->field->setGeometry(box);
}

void WorkingPanel::closeNumberField() {
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
}

QString WorkingPanel::enterTyped() {
  m_scrub.end(true);
  if (!m_typed)
    return {};
  QString why = m_typed->field->enter();
  if (why.isEmpty())
    closeNumberField();
  return why;
}

} // namespace halfspace
