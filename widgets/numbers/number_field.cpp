#include "widgets/numbers/number_field.h"

#include "lessons/language.h"
#include "lessons/reading/typed_number.h"
#include "lessons/scene/file/scene_reader.h"
#include "widgets/repolish.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>

namespace halfspace {
namespace {

constexpr int manySteps = 10;

/// Decimals that end within so many places are shown as decimals.
constexpr int shownPlaces = 4;
/// A number too long for its field is rounded to at most so many digits.
constexpr int mostShownDigits = 12;

/// What Qt keeps free beside the text of a line edit, in pixels.
constexpr int textMargin = 2;

/// The number rounded to so many digits: 1.2346, or 1.23·10⁻⁷ where it is very large or very small.
QString roundedTo(int digits, const Rational &value) {
  static const QString superscripts = QString::fromUtf8("⁰¹²³⁴⁵⁶⁷⁸⁹");
  const std::string plain = QString::number(toDouble(value), 'g', digits).toStdString();
  const QString text = QString::fromStdString(withDecimalMark(plain));
  const int mark = text.indexOf('e');
  if (mark < 0)
    return text;
  const int exponent = text.mid(mark + 1).toInt();
  QString power;
  for (const QChar digit : QString::number(std::abs(exponent)))
    power += superscripts.at(digit.digitValue());
  return text.left(mark) + QString::fromUtf8(exponent < 0 ? "·10⁻" : "·10") + power;
}

/// Whether so many digits tell all of a number.
bool isDecimalOf(int digits, const Rational &value) {
  const QString rounded = QString::number(toDouble(value), 'g', digits);
  return parseRational(rounded.toStdString()) == value;
}

/// Counted in the last place that is shown: whole where the decimal ends there.
Rational inLastPlaces(const Rational &value) { return value * powerOfTen(shownPlaces); }

/// What was typed, in the one spelling that files have too.
std::string fileSpelling(const QString &text) {
  return plainSpelling(text.toStdString(), language().decimalMark);
}

} // namespace

std::optional<Rational> parseTyped(const QString &text) { return parseRational(fileSpelling(text)); }

QString typedText(const Rational &value, NumberLook look) {
  const Rational scaled = inLastPlaces(value);
  if (look == NumberLook::Fraction || value.denominator() == 1 || scaled.denominator() != 1)
    return QString::fromStdString(toText(value));
  QString digits = QString::fromStdString(toText(abs(scaled)));
  digits = digits.rightJustified(shownPlaces + 1, '0');
  digits.insert(digits.size() - shownPlaces, language().decimalMark);
  while (digits.endsWith('0'))
    digits.chop(1);
  return (value < 0 ? "-" : "") + digits;
}

NumberLook lookOf(const ExactVec3 &numbers) {
  for (int axis = 0; axis < 3; ++axis)
    if (inLastPlaces(numbers[axis]).denominator() != 1)
      return NumberLook::Fraction;
  return NumberLook::Decimal;
}

NumberField::NumberField(QWidget *parent) : QLineEdit(parent), m_scrub(*this) {
  setAlignment(Qt::AlignRight);
  setCursor(Qt::SizeHorCursor);
  // A press may be the start of a scrub: the field takes the focus only when it was a click.
  setFocusPolicy(Qt::TabFocus);
  connect(this, &QLineEdit::returnPressed, this, &NumberField::enter);
  showValue();
}

QSize NumberField::minimumSizeHint() const {
  const int width = fontMetrics().horizontalAdvance(QStringLiteral("-00.00")) + fontMetrics().height();
  return {width, QLineEdit::minimumSizeHint().height()};
}

void NumberField::setValue(const Rational &value, NumberLook look) {
  const bool same = value == m_value && look == m_look;
  m_value = value;
  m_look = look;
  // What is being typed, or waits to be mended, is left alone.
  if (!same || (!hasFocus() && !property("wrong").toBool()))
    showValue();
}

QString NumberField::ownText() const { return typedText(m_value, m_look); }

void NumberField::showValue() {
  mark(false);
  const QString text = ownText();
  if (text == this->text())
    return;
  setText(text);
  setCursorPosition(0);
  setToolTip(text);
}

void NumberField::mark(bool wrong) {
  if (property("wrong").toBool() == wrong)
    return;
  setProperty("wrong", wrong);
  if (!wrong)
    emit refused({});
  repolish(*this);
}

std::optional<Rational> NumberField::typed() const {
  const auto value = text() == ownText() ? std::nullopt : parseTyped(text());
  return value && !refuseCoordinate(*value) ? value : std::nullopt;
}

QString NumberField::enter() {
  m_scrub.end(true);
  if (text() == ownText()) {
    showValue();
    return {};
  }
  const auto value = parseTyped(text());
  if (!value)
    return refuse(QString::fromStdString(
        sentenceForNotRead(withDecimalMark(fileSpelling(text())), language().decimalMark)));
  if (const auto why = refuseCoordinate(*value))
    return refuse(QString::fromStdString(*why));
  m_value = *value;
  showValue();
  emit valueTyped(*value);
  return {};
}

QString NumberField::refuse(const QString &sentence) {
  mark(true);
  emit refused(sentence);
  return sentence;
}

void NumberField::focusOutEvent(QFocusEvent *event) {
  enter();
  QLineEdit::focusOutEvent(event);
}

bool NumberField::event(QEvent *event) {
  // With nothing half typed in the field, undo and redo are the window's; so are the keys for the next step
  // and the one before, which Qt takes for words, and the key for a picture, which it takes for the end of
  // the line.
  if (event->type() == QEvent::ShortcutOverride && text() == ownText()) {
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool isPictureKey = key->key() == Qt::Key_E && key->modifiers() == Qt::ControlModifier;
    const bool isStepKey =
        key->matches(QKeySequence::MoveToNextWord) || key->matches(QKeySequence::MoveToPreviousWord);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo) || isPictureKey || isStepKey) {
      event->ignore();
      return true;
    }
  }
  return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent *event) {
  const int times = event->modifiers() & Qt::ControlModifier ? manySteps : 1;
  switch (event->key()) {
  case Qt::Key_Up:
    emit stepped(times);
    return;
  case Qt::Key_Down:
    emit stepped(-times);
    return;
  case Qt::Key_Escape:
    if (m_scrub.isScrubbing()) {
      m_scrub.end(false);
    } else {
      showValue();
      emit dropped();
    }
    return;
  default:
    QLineEdit::keyPressEvent(event);
  }
}

QRect NumberField::room() const {
  QStyleOptionFrame frame;
  initStyleOption(&frame);
  const QRect inside = style()->subElementRect(QStyle::SE_LineEditContents, &frame, this);
  return inside.adjusted(textMargin, 0, -textMargin, 0);
}

QString NumberField::shownText() const {
  const int width = room().width();
  const auto fits = [&](const QString &text) { return fontMetrics().horizontalAdvance(text) <= width; };
  if (hasFocus() || fits(text()))
    return text();
  if (property("wrong").toBool())
    return fontMetrics().elidedText(text(), Qt::ElideRight, width);
  QString rounded;
  for (int digits = mostShownDigits; digits > 0; --digits) {
    rounded = roundedTo(digits, m_value);
    if (!isDecimalOf(digits, m_value))
      rounded.prepend(QString::fromUtf8("≈ "));
    if (fits(rounded))
      break;
  }
  return rounded;
}

void NumberField::paintEvent(QPaintEvent *event) {
  const QString shown = shownText();
  if (shown == text())
    return QLineEdit::paintEvent(event);
  QStyleOptionFrame frame;
  initStyleOption(&frame);
  QPainter painter(this);
  style()->drawPrimitive(QStyle::PE_PanelLineEdit, &frame, &painter, this);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(room(), Qt::AlignRight | Qt::AlignVCenter, shown);
}

void NumberField::mousePressEvent(QMouseEvent *event) {
  // In what is being typed, the mouse chooses letters.
  const bool isTyping = text() != ownText();
  if (event->button() == Qt::LeftButton && !isTyping) {
    m_scrub.press(*event);
    return;
  }
  setFocus(Qt::MouseFocusReason); // what was refused waits without it
  QLineEdit::mousePressEvent(event);
}

/// All of 1/17, which Qt takes for two words.
void NumberField::mouseDoubleClickEvent(QMouseEvent *) { selectAll(); }

void NumberField::mouseMoveEvent(QMouseEvent *event) {
  if (m_scrub.isPressed())
    m_scrub.move(*event);
  else
    QLineEdit::mouseMoveEvent(event);
}

void NumberField::mouseReleaseEvent(QMouseEvent *event) {
  const bool wasClicked = m_scrub.isPressed() && !m_scrub.isScrubbing();
  if (!m_scrub.isPressed()) {
    QLineEdit::mouseReleaseEvent(event);
  } else if (wasClicked && hasFocus()) {
    deselect();
    setCursorPosition(cursorPositionAt(event->pos()));
  } else if (wasClicked) {
    setFocus(Qt::MouseFocusReason);
    selectAll();
  }
  m_scrub.end(true);
}

} // namespace halfspace
