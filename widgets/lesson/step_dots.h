// One dot for each step of a lesson.
#pragma once

#include "widgets/picture/theme.h"

#include <QWidget>

#include <vector>

namespace halfspace {

/// Shows which step is the current one; a click on another dot goes there.
class StepDots : public QWidget {
  Q_OBJECT
public:
  explicit StepDots(QWidget *parent = nullptr);

  /// The titles of the steps are told by tool tips.
  void setSteps(const QStringList &titles);
  void setCurrent(int step);
  void setTheme(const Theme &theme);

  [[nodiscard]] QSize sizeHint() const override;
  /// Where there is little room the dots stand closer.
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  void clicked(int step);

protected:
  void paintEvent(QPaintEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  bool event(QEvent *event) override;

private:
  [[nodiscard]] double spacing() const;
  [[nodiscard]] QSize sizeWith(double spacing) const;
  [[nodiscard]] QPointF center(int step) const;
  /// The step whose dot is nearest to a place; −1 without steps.
  [[nodiscard]] int stepAt(QPoint position) const;
  void tellAccessibly();

  QStringList m_titles;
  int m_current = 0;
  Theme m_theme;
};

} // namespace halfspace
