#include "app/window_style.h"

#include "app/panel_style.h"
#include "widgets/colors.h"

#include <QApplication>
#include <QPalette>
#include <QWidget>

namespace halfspace {
namespace {

/// The size of the panels' text at a text scale of 1, in points.
constexpr double usualPointSize = 9.75;

QPalette paletteOf(const Theme &theme) {
  QPalette palette;
  const QColor ink = toQColor(theme.ink);
  const QColor muted = toQColor(theme.mutedInk);
  const QColor panel = toQColor(theme.panel);
  const QColor base = toQColor(theme.backgroundBottom);
  palette.setColor(QPalette::Window, panel);
  palette.setColor(QPalette::WindowText, ink);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, panel);
  palette.setColor(QPalette::Text, ink);
  palette.setColor(QPalette::PlaceholderText, muted);
  palette.setColor(QPalette::Button, panel);
  palette.setColor(QPalette::ButtonText, ink);
  palette.setColor(QPalette::ToolTipBase, panel);
  palette.setColor(QPalette::ToolTipText, ink);
  palette.setColor(QPalette::Highlight, toQColor(theme.accent));
  palette.setColor(QPalette::HighlightedText, base);
  palette.setColor(QPalette::Link, toQColor(theme.accent));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, muted);
  return palette;
}

QString styleSheetOf(const Theme &theme) {
  const auto name = [](Color color) { return toQColor(color).name(); };
  return QString(R"(
    QMainWindow::separator { background: %1; width: 1px; height: 1px; }
    QMenuBar { background: %3; padding: 0.1em 0.3em; }
    QStatusBar { background: %3; color: %2; }
    QLabel#case { background: %3; padding: 0.6em 1.1em; border-top: 1px solid %1; font-weight: 500; }
    QLabel#case[degenerate="true"] { color: %4; }
    QListWidget#lessonList { border: none; background: %3; padding: 0.15em 0.45em; outline: none; }
    QListWidget#lessonList::item { padding: 0.4em 0.45em; border-radius: 5px; }
    QLabel#heading { color: %2; }
    QLabel#complaint { color: %4; }
    QLineEdit { border: 1px solid %1; border-radius: 4px; padding: 0.15em 0.4em; }
    QLineEdit:focus { border-color: %7; }
    QLineEdit[wrong="true"] { border-color: %4; color: %4; }
    QListWidget#lessonList::item:selected { background: %5; color: %6; }
  )")
      .arg(name(theme.border), name(theme.mutedInk), name(theme.panel), name(theme.warning),
           name(mix(theme.panel, theme.accent, 0.18)), name(theme.ink), name(theme.accent));
}

} // namespace

void applyStyle(QApplication &application, const Theme &theme) {
  // The same style everywhere: the platform's own would not take the theme's colours.
  application.setStyle(new PanelStyle(theme.textScale));
  application.setPalette(paletteOf(theme));
  QFont font = application.font();
  font.setPointSizeF(usualPointSize * theme.textScale);
  application.setFont(font);
  application.setStyleSheet(styleSheetOf(theme));
}

} // namespace halfspace
