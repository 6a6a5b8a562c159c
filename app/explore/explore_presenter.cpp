#include "app/explore/explore_presenter.h"

#include "app/explore/field_presenter.h"
#include "app/panels/scene_column.h"
#include "app/panels/window_panels.h"
#include "app/step/mark_highlights.h"
#include "lessons/scene/object_of_mark.h"
#include "widgets/explore/explore_panel.h"
#include "widgets/explore/fits_box.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/numbers/number_card.h"
#include "widgets/view/scene_view.h"

#include <QCursor>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QSplitter>

#include <algorithm>
#include <utility>

namespace halfspace {

ExplorePresenter::ExplorePresenter(SessionModel &model, WindowPanels &panels, MarkHighlights &highlights,
                                   FieldPresenter &field, QObject *parent)
    : QObject(parent), m_model(model), m_panels(panels), m_highlights(highlights), m_field(field),
      m_selection(panels.explore().selection()) {
  SceneView &view = panels.scene().view();
  connect(&model, &SessionModel::lessonChanged, this, &ExplorePresenter::takeLesson);
  connect(&model, &SessionModel::outcomeChanged, this, &ExplorePresenter::takeScene);
  connect(&m_selection, &SceneSelection::changed, this, &ExplorePresenter::showSelection);
  connect(&view.input(), &SceneInput::clicked, this, &ExplorePresenter::choose);
  connect(&view.input(), &SceneInput::menuWanted, this, &ExplorePresenter::showMenu);
  connect(&view.handles(), &SceneHandles::selectionChanged, this, [this] {
    // A click of the mouse is told by what it clicked on.
    if (QGuiApplication::mouseButtons() == Qt::NoButton)
      takeHandle();
  });
  connect(&model.history(), &SessionHistory::gestureEnded, this, &ExplorePresenter::takeHandle);
  connect(&panels.explore().list(), &EntryList::menuShown, this, &ExplorePresenter::addPin);
  connect(&panels.explore().fits(), &FitsBox::previewed, &view.drawn(), &DrawnFigure::setGhost);
  takeLesson();
}

void ExplorePresenter::takeLesson() {
  const auto &entries = m_model.session().scene.entries;
  m_entries = entries.size();
  m_last = entries.empty() ? std::string() : entries[entries.size() - 1].name;
  const bool isStillThere = isExplore(m_model) && !m_panels.explore().isHidden();
  if (!isStillThere) {
    m_pinned.clear();
    m_selection.set({});
    m_panels.explore().setVisible(isExplore(m_model));
    if (isExplore(m_model))
      m_panels.side().setSizes({1000, 1000}); // halves: only their ratio counts
  }
  std::erase_if(m_pinned, [&](const std::string &name) { return !entries.find(name); });
  showWorkings();
}

void ExplorePresenter::takeScene() {
  const Scene &scene = m_model.session().scene;
  std::vector<std::string> ids = m_selection.ids();
  std::erase_if(ids, [&](const std::string &id) { return !scene.entries.find(ownerOf(id)); });
  if (ids == m_selection.ids())
    showWorkings(); // of others, where the last construction is another one
  m_selection.set(std::move(ids));
  if (!m_selection.ids().empty())
    highlight(); // another case has other marks
  if (isExplore(m_model))
    takeEntries();
}

void ExplorePresenter::takeEntries() {
  const auto &entries = m_model.session().scene.entries;
  const std::string last = entries.empty() ? std::string() : entries[entries.size() - 1].name;
  const std::size_t before = std::exchange(m_entries, entries.size());
  const bool isNew = std::exchange(m_last, last) != last;
  if (before == entries.size())
    return;
  m_panels.scene().view().viewpoint().takeGrown();
  if (isNew && before < entries.size())
    m_selection.set({last});
}

void ExplorePresenter::choose(const QString &mark, bool adds) {
  if (!isExplore(m_model))
    return;
  const std::string id = objectOfMark(m_model.evaluation(), mark.toStdString());
  if (adds && !id.empty())
    m_selection.toggle(id);
  else if (!adds)
    m_selection.set(id.empty() ? std::vector<std::string>() : std::vector{id});
}

void ExplorePresenter::showMenu(const QString &mark) {
  const std::string id = objectOfMark(m_model.evaluation(), mark.toStdString());
  if (!isExplore(m_model) || id.empty())
    return;
  if (!m_selection.contains(id))
    m_selection.set({id});
  m_panels.explore().list().showMenu(QCursor::pos());
}

void ExplorePresenter::takeHandle() {
  const auto selected = m_panels.scene().view().handles().selectedCoordinate();
  if (isExplore(m_model) && selected && !m_selection.contains(selected->object))
    m_selection.set({selected->object});
}

bool ExplorePresenter::pressKey(const QKeyEvent &event) {
  const QString text = event.text();
  const bool isPlain = !(event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
  if (!isExplore(m_model) || !isPlain)
    return false;
  if (event.key() == Qt::Key_Delete && !m_selection.ids().empty()) {
    m_panels.explore().edits().remove(m_selection.ids());
    return true;
  }
  if (text.isEmpty() || !text.front().isLetter())
    return false;
  m_field.begin(text);
  return true;
}

void ExplorePresenter::showSelection() {
  highlight();
  selectHandle();
  showWorkings();
}

void ExplorePresenter::highlight() {
  std::set<std::string> marks;
  for (const Mark &mark : m_model.figure().marks)
    if (m_selection.contains(objectOfMark(m_model.evaluation(), baseOf(mark).id)))
      marks.insert(baseOf(mark).id);
  m_highlights.setSelected(isExplore(m_model) ? marks : std::set<std::string>());
}

void ExplorePresenter::selectHandle() {
  SceneHandles &handles = m_panels.scene().view().handles();
  const auto selected = handles.selectedCoordinate();
  const std::string object = m_selection.ids().size() == 1 ? m_selection.ids().front() : std::string();
  if (!isExplore(m_model) || (selected && selected->object == object))
    return;
  const std::vector<Handle> &all = handles.selection().handles();
  const auto first =
      std::find_if(all.begin(), all.end(), [&](const Handle &handle) { return handle.object == object; });
  handles.select(first == all.end() ? std::string() : first->id);
  if (const Object *number = findObject(m_model.session().scene, object); number && first == all.end())
    m_panels.scene().card().setSelection(CoordinateId{object, 0}); // it has no place to be dragged
}

void ExplorePresenter::showWorkings() {
  if (!isExplore(m_model))
    return;
  std::set<std::string> wanted = m_pinned;
  for (const std::string &id : m_selection.ids())
    wanted.insert(ownerOf(id));
  std::vector<std::string> shown;
  for (const EvaluatedEntry &entry : m_model.evaluation().entries)
    if (wanted.contains(entry.name) && !entry.outcome->told->description.empty())
      shown.push_back(entry.name);
  if (shown.empty())
    shown = lastOfInterest();
  if (m_model.showWorkings(shown))
    m_panels.page().showTop();
}

std::vector<std::string> ExplorePresenter::lastOfInterest() const {
  if (m_selection.ids().empty()) {
    const EvaluatedEntry *last = m_model.evaluation().lastConstruction();
    return last ? std::vector{last->name} : std::vector<std::string>();
  }
  std::set<std::string> known; // what is selected, and what follows it
  for (const std::string &id : m_selection.ids())
    known.insert(ownerOf(id));
  std::vector<std::string> found;
  for (const Entry &entry : m_model.session().scene.entries) {
    const std::vector<std::string> ids = referencesIn(entry);
    if (std::none_of(ids.begin(), ids.end(),
                     [&](const std::string &id) { return known.contains(ownerOf(id)); }))
      continue;
    known.insert(entry.name);
    if (std::holds_alternative<ConstructionUse>(entry.content))
      found = {entry.name};
  }
  return found;
}

void ExplorePresenter::addPin(QMenu &menu, const QString &name) {
  const std::string entry = name.toStdString();
  const EvaluatedEntry *evaluated = m_model.evaluation().find(entry);
  if (!evaluated || !evaluated->isConstruction())
    return;
  QAction *pin = menu.addAction(tr("&Keep Its Working on the Page"));
  pin->setCheckable(true);
  pin->setChecked(m_pinned.contains(entry));
  connect(pin, &QAction::triggered, this, [this, entry](bool on) {
    if (on)
      m_pinned.insert(entry);
    else
      m_pinned.erase(entry);
    showWorkings();
  });
}

} // namespace halfspace
