// A button of what can be made.
#pragma once

#include <QPushButton>

namespace halfspace {

/// Shortens its title where there is less room than that takes.
class FitButton : public QPushButton {
public:
  explicit FitButton(const QString &title);

  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent *event) override;
};

} // namespace halfspace
