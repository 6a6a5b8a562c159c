#include "app/panels/window_style.h"

#include "app/panels/panel_style.h"
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
    QMenuBar::item { padding: 0.35em 0.55em; background: transparent; }
    QMenuBar::item:selected { background: %5; }
    QSplitter::handle { background: %3; }
    QSplitter::handle:horizontal { width: 5px; border-left: 1px solid %1; }
    QSplitter::handle:vertical { height: 5px; border-top: 1px solid %1; }
    QLabel#lessonTitle { color: %2; padding: 0.35em 1.1em; }
    QToolButton#contentsButton { margin: 0 0.3em; }
    QToolButton#sceneTool { background: %3; border: 1px solid %1; border-radius: 5px; padding: 0.35em; }
    QToolButton#addTool { background: %3; border: 1px solid %1; border-radius: 4px; padding: 0.3em 1.4em 0.3em 0.7em; }
    QToolButton#addTool:hover, QToolButton#addTool:focus { background: %5; }
    QToolButton#sceneTool:hover, QToolButton#sceneTool:checked { background: %5; }
    QToolButton#showLine { color: %2; border: 1px solid %1; border-radius: 4px; padding: 0.1em 0.35em; }
    QToolButton#showLine:hover, QToolButton#showLine:focus { color: %6; border-color: %7; }
    QToolButton#fading { padding-right: 1em; }
    QToolButton::menu-indicator { subcontrol-position: right center; }
    QLabel#case, QLabel#usualCase { background: %3; padding: 0.3em 1.1em 0.1em 1.1em; border-top: 1px solid %1; font-weight: 500; }
    QLabel#case[degenerate="true"] { color: %4; }
    halfspace--CaseLine { background: %3; }
    QLabel#nearby, QLabel#usualNearby, QLabel#message { padding: 0 0.4em 0.25em 1.1em; color: %2; }
    QPushButton#there, QPushButton#others, QPushButton#afresh { color: %7; border: none; padding: 0 1.1em 0.35em 0; text-decoration: underline; }
    QToolButton#hint, QToolButton#formulaLesson { color: %7; border: none; padding: 0.1em 0; text-decoration: underline; }
    QToolButton#hint:focus, QToolButton#formulaLesson:focus { background: %5; }
    halfspace--CaseLine QLabel#complaint { padding: 0.5em 1.1em; border-top: 1px solid %1; }
    QLabel#sceneNotice { background: %3; color: %4; border: 1px solid %1; border-radius: 5px; padding: 0.35em 0.6em; }
    QFrame#flatView { background: %3; border: 1px solid %1; border-radius: 5px; }
    QToolButton#flatTitle { color: %2; padding: 0.2em 0.5em; }
    QFrame#card { border: 1px solid transparent; border-radius: 7px; }
    QFrame#card[framed="true"] { background: %3; border-color: %1; }
    QLabel#hint { color: %2; background: %3; border-radius: 4px; }
    QFrame#contents { background: %3; border-right: 1px solid %1; }
    QLabel#contentsHeading { color: %2; padding: 0.7em 0.9em 0.4em 0.9em; }
    QLineEdit#lessonSearch { margin: 0 0.75em 0.4em 0.75em; }
    QListWidget#lessonList { border: none; background: %3; padding: 0.15em 0.45em; outline: none; }
    QListWidget#lessonList::item { padding: 0.4em 2.4em 0.4em 0.45em; border-radius: 5px; }
    QLabel#heading, QLabel#sessionNote, QLabel#figureSize, QLabel#wordsHint, QLabel#conditionNow, QLabel#leftOut { color: %2; }
    QLabel#conditionNow[wrong="true"] { color: %4; }
    QLabel#exportMessage[wrong="true"] { color: %4; }
    QLabel#complaint { color: %4; }
    QLineEdit { border: 1px solid %1; border-radius: 4px; padding: 0.15em 0.4em; }
    QLineEdit:focus { border-color: %7; }
    QLineEdit[wrong="true"] { border-color: %4; color: %4; }
    QWidget#entryBar { background: %3; border-bottom: 1px solid %1; }
    QLineEdit#entryField { font-size: 110%; padding: 0.3em 0.5em; }
    QFrame#suggestions { border: 1px solid %1; border-radius: 4px; background: %3; }
    QFrame#suggestions QTreeView { border: none; background: transparent; }
    QFrame#suggestions QTreeView::item { border: none; padding: 0.25em 0.5em; }
    QFrame#suggestions QTreeView::item:selected { background: %5; color: %6; }
    QLabel#entrySentence { color: %2; padding: 0.35em 0.6em; }
    QLabel#entrySentence[wrong="true"] { color: %4; }
    QTreeView#entryList { border: 1px solid %1; border-radius: 4px; }
    QTreeView#entryList::item { padding: 0.2em 0; }
    QTreeView#entryList::item:selected { background: %5; color: %6; }
    QListWidget#lessonList::item:selected { background: %5; color: %6; }
    QScrollBar { background: transparent; }
    QScrollBar:vertical { width: 0.75em; }
    QScrollBar:horizontal { height: 0.75em; }
    QScrollBar::handle { background: %8; border-radius: 0.3em; }
    QScrollBar::handle:hover { background: %2; }
    QScrollBar::handle:vertical { min-height: 2em; }
    QScrollBar::handle:horizontal { min-width: 2em; }
    QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
    QScrollBar::add-page, QScrollBar::sub-page { background: none; }
  )")
      .arg(name(theme.border), name(theme.mutedInk), name(theme.panel), name(theme.warning),
           name(mix(theme.panel, theme.accent, 0.18)), name(theme.ink), name(theme.accent),
           name(mix(theme.panel, theme.mutedInk, 0.5)));
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
