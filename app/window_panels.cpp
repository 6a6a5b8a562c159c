// Where the panels of the window stand, and what of them is heard.
#include "app/main_window.h"
#include "app/page_width.h"
#include "widgets/lesson/contents_drawer.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/view/case_line.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_frame.h"
#include "widgets/working/working_practice.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QSplitter>
#include <QToolButton>

namespace halfspace {

void MainWindow::connectPanels() {
  connect(m_split, &QSplitter::splitterMoved, this, [this] { m_isSplitChosen = true; });
  // Once what it takes, or gives back, is known.
  connect(m_numbersDock, &QDockWidget::visibilityChanged, this, &MainWindow::sharePage, Qt::QueuedConnection);
  connect(m_contents, &ContentsDrawer::lessonChosen, this,
          [this](const QString &id) { m_model.openLesson(id.toStdString()); });
}

/// In the row of the menus: the way to the contents, and the lesson's title.
void MainWindow::createHeader() {
  m_contentsButton = new QToolButton;
  m_contentsButton->setObjectName("contentsButton");
  m_contentsButton->setToolTip(tr("All lessons"));
  m_contentsButton->setAccessibleName(tr("Contents"));
  m_contentsButton->setAutoRaise(true);
  m_contentsButton->setCheckable(true);
  connect(m_contentsButton, &QToolButton::clicked, this, [this](bool open) {
    if (open)
      showContents();
    else
      m_contents->close();
  });
  connect(m_contents, &ContentsDrawer::openChanged, m_contentsButton, &QToolButton::setChecked);
  m_lessonTitle = new QLabel;
  m_lessonTitle->setObjectName("lessonTitle");
  m_lessonTitle->setTextFormat(Qt::PlainText);
  menuBar()->setCornerWidget(m_contentsButton, Qt::TopLeftCorner);
  menuBar()->setCornerWidget(m_lessonTitle, Qt::TopRightCorner);
}

void MainWindow::createSceneTools() {
  m_frame->addTool(*m_home, ToolIcon::Home);
  m_frame->addTool(*m_fit, ToolIcon::Fit);
  m_frame->addTool(*m_alongPlane, ToolIcon::AlongPlane);
  m_frame->addTool(*m_numbersDock->toggleViewAction(), ToolIcon::Numbers);
}

void MainWindow::sharePage() {
  const bool below = isPageBelow(size());
  m_split->setOrientation(below ? Qt::Vertical : Qt::Horizontal);
  if (m_isSplitChosen)
    return;
  // The split's own width is that of before while the window is on its way to another size.
  const bool isDocked = m_numbersDock->isVisible() && !m_numbersDock->isFloating();
  const int whole = below ? m_split->height() : width() - (isDocked ? m_numbersDock->width() : 0);
  const int page =
      below ? static_cast<int>(pageShareBelow * whole) : pageWidthIn(whole, m_page->fontMetrics());
  m_split->setSizes({whole - page, page});
}

double MainWindow::pageTypeScale() const {
  return m_sceneColumn->isHidden()
             ? typeScaleAlone(width(), LessonPage::longestLine(QFontMetrics(QApplication::font())))
             : 1;
}

void MainWindow::showPageLook() {
  m_pageTypeScale = pageTypeScale();
  Theme theme = m_theme;
  theme.textScale *= sizeScale() * m_pageTypeScale;
  QFont type = QApplication::font();
  type.setPointSizeF(type.pointSizeF() * m_pageTypeScale);
  m_page->setFont(type);
  m_page->setTheme(theme);
  sharePage();
  // Once all parts have their new sizes: the page may have been wider than it must be now.
  QTimer::singleShot(0, this, &MainWindow::sharePage);
}

void MainWindow::resizeEvent(QResizeEvent *event) {
  QMainWindow::resizeEvent(event);
  if (pageTypeScale() != m_pageTypeScale)
    showPageLook();
  sharePage();
  m_caseLine->setWindowHeight(height());
  showLessonTitle();
}

void MainWindow::showLessonTitle() {
  m_lessonTitle->setText(QString::fromStdString(m_model.lesson().title));
  m_lessonTitle->hide(); // the menus alone
  m_lessonTitle->setVisible(menuBar()->sizeHint().width() + m_lessonTitle->sizeHint().width() <= width());
}

void MainWindow::showParts(Parts parts) {
  m_sceneColumn->setVisible(parts != Parts::PageOnly);
  m_page->setVisible(parts != Parts::SceneOnly);
  m_sceneOnly->setChecked(parts == Parts::SceneOnly);
  m_pageOnly->setChecked(parts == Parts::PageOnly);
  showPageLook();
}

void MainWindow::setFullScreen(bool on) {
  m_fullScreen->setChecked(on);
  setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::restoreLayout() {
  showParts(Parts::Both);
  setFullScreen(false);
  m_numbersDock->setFloating(false);
  m_numbersDock->hide();
  m_isSplitChosen = false;
  sharePage();
}

} // namespace halfspace
