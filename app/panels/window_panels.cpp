#include "app/panels/window_panels.h"

#include "app/panels/scene_column.h"
#include "app/panels/unfinished_input.h"
#include "widgets/explore/explore_panel.h"
#include "widgets/lesson/contents_drawer.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/numbers/inspector.h"
#include "widgets/numbers/number_card.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/view/scene_view.h"
#include "widgets/working/working_editor.h"
#include "widgets/working/working_practice.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QSplitter>
#include <QVBoxLayout>

namespace halfspace {
namespace {

// Of the height beside the scene in Explore.
constexpr int listShare = 1;
constexpr int pageShare = 1;

} // namespace

WindowPanels::WindowPanels(QMainWindow &window, SessionModel &model)
    : m_typesetter(std::make_unique<Typesetter>()), m_window(window),
      m_scene(new SceneColumn(model, *m_typesetter)), m_practice(new WorkingPractice(*m_typesetter)),
      m_page(new LessonPage(*m_typesetter, *m_practice)), m_explore(new ExplorePanel(model)),
      m_side(new QSplitter(Qt::Vertical)), m_split(new QSplitter) {
  m_side->setChildrenCollapsible(false);
  m_side->addWidget(m_explore);
  m_side->addWidget(m_page);
  m_side->setStretchFactor(0, listShare);
  m_side->setStretchFactor(1, pageShare);
  m_split->setChildrenCollapsible(false);
  m_split->addWidget(m_scene);
  m_split->addWidget(m_side);
  m_split->setStretchFactor(0, 1);
  m_split->setStretchFactor(1, 0);
  auto *center = new QWidget;
  auto *layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_split);
  window.setCentralWidget(center);
  // Tab goes through the window in the order in which its parts come into it.
  m_inspector = new Inspector(model, *m_typesetter);
  m_numbersDock = new QDockWidget(tr("Numbers"), &window);
  m_numbersDock->setObjectName("numbersDock");
  m_numbersDock->setWidget(m_inspector);
  window.addDockWidget(Qt::LeftDockWidgetArea, m_numbersDock);
  m_numbersDock->hide();
  m_contents = new ContentsDrawer(center); // a splitter would make it a third part
  StepWorking &working = m_practice->working();
  m_input = std::make_unique<UnfinishedInput>(m_scene->view().input(), working,
                                              std::vector{&m_inspector->given(), &m_scene->card().given()},
                                              *new WorkingEditor(model, working), messages());
}

WindowPanels::~WindowPanels() {
  m_input.reset(); // it is not to hear of the end of the others
  delete m_window.takeCentralWidget();
  delete m_numbersDock;
}

Messages WindowPanels::messages() { return {m_window, m_scene->caseLine()}; }

void WindowPanels::setLook(const Theme &theme, double sizeScale, const Theme &panels) {
  m_scene->setLook(theme, sizeScale, panels);
  m_practice->working().setTheme(panels);
  m_inspector->setTheme(panels);
  m_contents->setTheme(panels);
  m_explore->setTheme(panels);
}

} // namespace halfspace
