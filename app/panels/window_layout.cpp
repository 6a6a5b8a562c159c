#include "app/panels/window_layout.h"

#include "app/panels/page_width.h"
#include "app/panels/scene_column.h"
#include "app/panels/window_panels.h"
#include "widgets/lesson/lesson_page.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>
#include <QSplitter>
#include <QTimer>

namespace halfspace {
namespace {

constexpr QSize usualSize(1280, 800);

} // namespace

WindowLayout::WindowLayout(QMainWindow &window, WindowPanels &panels)
    : QObject(&window), m_window(window), m_split(panels.split()), m_scene(panels.scene()),
      m_side(panels.side()), m_page(panels.page()), m_numbersDock(panels.numbersDock()),
      m_sceneOnly(addChoice(tr("&Scene Only"), Qt::Key_F9)),
      m_pageOnly(addChoice(tr("Pa&ge Only"), Qt::Key_F8)),
      m_fullScreen(addChoice(tr("F&ull Screen"), Qt::Key_F11)),
      m_restore(new QAction(tr("Restore &Layout"), this)) {
  m_restore->setObjectName("restoreLayout");
  connect(m_sceneOnly, &QAction::triggered, this,
          [this](bool on) { showParts(on ? Parts::SceneOnly : Parts::Both); });
  connect(m_pageOnly, &QAction::triggered, this,
          [this](bool on) { showParts(on ? Parts::PageOnly : Parts::Both); });
  connect(m_fullScreen, &QAction::triggered, this, &WindowLayout::setFullScreen);
  connect(m_restore, &QAction::triggered, this, &WindowLayout::restore);
  connect(&m_split, &QSplitter::splitterMoved, this, [this] { m_isSplitChosen = true; });
  // Once what it takes, or gives back, is known.
  connect(&m_numbersDock, &QDockWidget::visibilityChanged, this, &WindowLayout::share, Qt::QueuedConnection);
}

QAction *WindowLayout::addChoice(const QString &text, const QKeySequence &key) {
  auto *action = new QAction(text, this);
  action->setCheckable(true);
  action->setShortcut(key);
  return action;
}

QList<QAction *> WindowLayout::actions() const { return {m_sceneOnly, m_pageOnly, m_fullScreen, m_restore}; }

void WindowLayout::share() {
  const bool below = isPageBelow(m_window.size());
  m_split.setOrientation(below ? Qt::Vertical : Qt::Horizontal);
  if (m_isSplitChosen)
    return;
  // The split's own width is that of before while the window is on its way to another size.
  const bool isDocked = m_numbersDock.isVisible() && !m_numbersDock.isFloating();
  const int whole = below ? m_split.height() : m_window.width() - (isDocked ? m_numbersDock.width() : 0);
  const int page =
      below ? static_cast<int>(pageShareBelow * whole) : pageWidthIn(whole, m_page.fontMetrics());
  m_split.setSizes({whole - page, page});
}

double WindowLayout::pageTypeScale() const {
  return m_scene.isHidden()
             ? typeScaleAlone(m_window.width(), LessonPage::longestLine(QFontMetrics(QApplication::font())))
             : 1;
}

void WindowLayout::setPageTheme(const Theme &theme) {
  m_pageTheme = theme;
  showPage();
}

void WindowLayout::showPage() {
  m_pageTypeScale = pageTypeScale();
  Theme theme = m_pageTheme;
  theme.textScale *= m_pageTypeScale;
  QFont type = QApplication::font();
  type.setPointSizeF(type.pointSizeF() * m_pageTypeScale);
  m_page.setFont(type);
  m_page.setTheme(theme);
  share();
  // Once all parts have their new sizes: the page may have been wider than it must be now.
  QTimer::singleShot(0, this, &WindowLayout::share);
}

void WindowLayout::takeSize() {
  if (pageTypeScale() != m_pageTypeScale)
    showPage();
  share();
  emit sizeTaken();
}

void WindowLayout::showParts(Parts parts) {
  m_scene.setVisible(parts != Parts::PageOnly);
  m_side.setVisible(parts != Parts::SceneOnly);
  m_sceneOnly->setChecked(parts == Parts::SceneOnly);
  m_pageOnly->setChecked(parts == Parts::PageOnly);
  showPage();
}

void WindowLayout::setFullScreen(bool on) {
  m_fullScreen->setChecked(on);
  m_window.setWindowState(on ? m_window.windowState() | Qt::WindowFullScreen
                             : m_window.windowState() & ~Qt::WindowFullScreen);
}

void WindowLayout::restore() {
  showParts(Parts::Both);
  setFullScreen(false);
  m_numbersDock.setFloating(false);
  m_numbersDock.hide();
  m_isSplitChosen = false;
  share();
}

void WindowLayout::takeGeometry(const Settings &settings) {
  const QScreen &screen = *m_window.screen();
  if (!m_window.restoreGeometry(settings.window))
    m_window.resize(
        (usualSize * settings.sizeScale.value_or(usualSizeScale(screen))).boundedTo(screen.availableSize()));
}

void WindowLayout::takePanels(const Settings &settings) {
  m_window.restoreState(settings.panels);
  m_isSplitChosen = m_split.restoreState(settings.split);
  share();
}

void WindowLayout::put(Settings &settings) {
  setFullScreen(false);
  settings.window = m_window.saveGeometry();
  settings.panels = m_window.saveState();
  if (m_isSplitChosen)
    settings.split = m_split.saveState();
}

} // namespace halfspace
