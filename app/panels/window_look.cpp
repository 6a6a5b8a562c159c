#include "app/panels/window_look.h"

#include <QScreen>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace halfspace {

WindowLook::WindowLook(QWidget &window)
    : QObject(&window), m_window(window), m_theme(themes().front()), m_motion(this) {
  m_motion.setText(tr("&Motion"));
  m_motion.setObjectName("motion");
  m_motion.setCheckable(true);
  m_motion.setChecked(true);
}

Theme WindowLook::panelTheme() const {
  Theme theme = m_theme;
  theme.textScale *= sizeScale();
  return theme;
}

void WindowLook::setThemeNamed(const QString &name) {
  const Theme *theme = findTheme(name.toStdString());
  if (!theme)
    return;
  m_theme = *theme;
  emit changed();
}

void WindowLook::chooseTheme(const QString &name) {
  setThemeNamed(name);
  emit chosen();
}

double WindowLook::sizeScale() const { return std::min(m_sizeScale, largestSizeScale / m_theme.textScale); }

void WindowLook::setSizeScale(double scale) {
  m_sizeScale = std::clamp(scale, smallestSizeScale, largestSizeScale);
  emit changed();
}

void WindowLook::changeSizeBy(int steps) {
  setSizeScale((std::round(sizeScale() / sizeScaleStep) + steps) * sizeScaleStep);
  emit chosen();
}

void WindowLook::chooseUsualSize() {
  setSizeScale(usualSizeScale(*m_window.screen()));
  emit chosen();
}

bool WindowLook::canGrow() const { return panelTheme().textScale < largestSizeScale; }

bool WindowLook::canShrink() const { return m_sizeScale > smallestSizeScale; }

void WindowLook::take(const Settings &settings) {
  setSizeScale(settings.sizeScale.value_or(usualSizeScale(*m_window.screen())));
  setThemeNamed(settings.theme);
  m_motion.setChecked(settings.motion);
}

void WindowLook::putTheme(Settings &settings) const {
  settings.theme = QString::fromStdString(m_theme.name);
  const bool suitsTheScreen =
      m_sizeScale == usualSizeScale(*m_window.screen()); // another screen may have another one
  settings.sizeScale = suitsTheScreen ? std::nullopt : std::optional(m_sizeScale);
}

} // namespace halfspace
