// A value with its name.
#pragma once

#include "widgets/text/math_label.h"

namespace halfspace {

/// The name beside its value where both fit, else above it: a value is not drawn small to make room for a
/// long name. There each of them is broken before it is drawn smaller.
class NamedValueRow : public QWidget {
  Q_OBJECT

public:
  explicit NamedValueRow(const Typesetter &typesetter, QWidget *parent = nullptr);

  [[nodiscard]] MathLabel &name() { return *m_name; }
  [[nodiscard]] MathLabel &value() { return *m_value; }

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  bool event(QEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;

private:
  [[nodiscard]] int nameColumn() const;
  [[nodiscard]] int indent() const; ///< of a value below its name
  [[nodiscard]] bool isStacked(int width) const;
  void place();

  MathLabel *m_name;
  MathLabel *m_value;
};

} // namespace halfspace
