// A field for one exact number: typed, stepped with the keys, or scrubbed with the mouse.
#pragma once

#include "lessons/object/object.h"
#include "widgets/numbers/scrub.h"

#include <QLineEdit>

namespace halfspace {

/// How a number is written for typing.
enum class NumberLook {
  Decimal, ///< where it ends soon; else a fraction
  Fraction
};

/// Shows a fraction exactly. Typing takes `-10/3`, `1.5`, and `1,5` where the language writes it so. Up and
/// Down step it; a number too long for the field is shown rounded after ≈ until the field has the focus.
/// Pressing on a field in which nothing is half typed and dragging sideways scrubs it. A text that is no
/// number stays, marked, until it is mended or Escape takes it back.
class NumberField : public QLineEdit {
  Q_OBJECT

public:
  explicit NumberField(QWidget *parent = nullptr);

  void setValue(const Rational &value, NumberLook look = NumberLook::Decimal);
  [[nodiscard]] const Rational &value() const { return m_value; }
  /// The hand that drags the number sideways.
  [[nodiscard]] const Scrub &scrub() const { return m_scrub; }

  /// The number that is typed and not entered yet; nothing where none is, or it would be refused.
  [[nodiscard]] std::optional<Rational> typed() const;
  /// Ends a scrub, and takes the text for the value. Why it is refused; else empty.
  QString enter();
  /// Shows the value again instead of what is typed.
  void drop() { showValue(); }

  /// What can be read in the field: the text, or the number rounded after ≈ where the text is too long.
  [[nodiscard]] QString shownText() const;

  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  void valueTyped(const halfspace::Rational &value);
  void refused(const QString &sentence); ///< why a typed text is not taken; empty once it is mended
  void dropped();                        ///< Escape: what was typed is not wanted
  void stepped(int steps);               ///< by keys: so many snapping steps up or down

protected:
  bool event(QEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mouseReleaseEvent(QMouseEvent *event) override;
  void mouseDoubleClickEvent(QMouseEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void focusOutEvent(QFocusEvent *event) override;
  void paintEvent(QPaintEvent *event) override;

private:
  QString refuse(const QString &sentence);
  [[nodiscard]] QRect room() const;
  [[nodiscard]] QString ownText() const;
  void showValue();
  void mark(bool wrong);

  Rational m_value = 0;
  NumberLook m_look = NumberLook::Decimal;
  Scrub m_scrub;
};

/// A number as a user types it, with the decimal comma where the language has it: see plainSpelling.
[[nodiscard]] std::optional<Rational> parseTyped(const QString &text);

/// The exact text of a number for typing.
[[nodiscard]] QString typedText(const Rational &value, NumberLook look = NumberLook::Decimal);

/// One look for the numbers of a point: decimals where all end soon, else fractions.
[[nodiscard]] NumberLook lookOf(const ExactVec3 &numbers);

} // namespace halfspace
