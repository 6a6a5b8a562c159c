#include "widgets/explore/entry_list.h"

#include "lessons/object/kind.h"
#include "widgets/colors.h"
#include "widgets/explore/swatch.h"
#include "widgets/scene_selection.h"

#include <QActionGroup>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// What people call a colour.
QString titleOf(Hue hue) {
  switch (hue) {
  case Hue::Grey:
    return EntryList::tr("Grey");
  case Hue::Blue:
    return EntryList::tr("Blue");
  case Hue::Orange:
    return EntryList::tr("Orange");
  case Hue::Yellow:
    return EntryList::tr("Yellow");
  case Hue::Green:
    return EntryList::tr("Green");
  case Hue::Purple:
    return EntryList::tr("Purple");
  case Hue::Pink:
    return EntryList::tr("Pink");
  case Hue::Red:
    break;
  }
  return EntryList::tr("Red");
}

/// An item of a menu that shows whether it is chosen.
template <class Slot> QAction &addToggle(QMenu &menu, const QString &text, bool isChosen, Slot slot) {
  QAction &toggle = *menu.addAction(text);
  toggle.setCheckable(true);
  toggle.setChecked(isChosen);
  QObject::connect(&toggle, &QAction::triggered, &menu, slot);
  return toggle;
}

/// The items of a menu of which one is chosen.
class Choices {
public:
  explicit Choices(QMenu &menu) : m_menu(menu), m_group(new QActionGroup(&menu)) {}

  template <class Slot> QAction &add(const QString &text, bool isChosen, Slot slot) {
    QAction &choice = addToggle(m_menu, text, isChosen, slot);
    m_group->addAction(&choice);
    return choice;
  }

private:
  QMenu &m_menu;
  QActionGroup *m_group;
};

/// Whether the entry is drawn in a colour of its own: an object is, and of a construction its results are.
bool isColored(const Entry &entry, const EvaluatedEntry &evaluated) {
  const Figure &figure = *evaluated.outcome->figure;
  const auto isResult = [&](const Mark &mark) { return isOfResult(baseOf(mark), evaluated); };
  return isDrawn(entry) && (kindOf(entry) || std::any_of(figure.marks.begin(), figure.marks.end(), isResult));
}

/// Whether its lines can be dashed.
bool isLined(const Entry &entry, const EvaluatedEntry &evaluated) {
  const Figure &figure = *evaluated.outcome->figure;
  const auto isLine = [&](const Mark &mark) {
    return isOfResult(baseOf(mark), evaluated) && !std::holds_alternative<PointMark>(mark) &&
           !std::holds_alternative<SphereMark>(mark);
  };
  return hasLines(entry) && (kindOf(entry) || std::any_of(figure.marks.begin(), figure.marks.end(), isLine));
}

} // namespace

EntryList::EntryList(SessionModel &model, SceneSelection &selection, EntryEdits &edits, QWidget *parent)
    : QTreeView(parent), m_model(model), m_selection(selection), m_edits(edits),
      m_rows(new EntryRows(model, this)), m_theme(themes().front()) {
  setObjectName("entryList");
  setAccessibleName(tr("What is in the scene"));
  setModel(m_rows);
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(EditKeyPressed);
  setDragDropMode(InternalMove);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(QHeaderView::Stretch);
  header()->setSectionResizeMode(EntryRows::Name, QHeaderView::ResizeToContents);
  header()->setResizeContentsPrecision(0); // of what is seen: a drag tells of all rows in each frame
  connect(verticalScrollBar(), &QScrollBar::valueChanged, this,
          [this] { resizeColumnToContents(EntryRows::Name); });
  connect(&selection, &SceneSelection::changed, this, &EntryList::followSelection);
  connect(m_rows, &EntryRows::modelReset, this, &EntryList::followSelection);
  connect(this, &EntryList::doubleClicked, this, &EntryList::askForLine);
  connect(m_rows, &EntryRows::renamed, this, [this](const QString &name, const QString &newName) {
    if (m_edits.rename(name.toStdString(), newName.toStdString()))
      m_selection.set({newName.toStdString()});
  });
  connect(m_rows, &EntryRows::hiddenChosen, &edits,
          [&edits](const QString &name, bool hidden) { edits.setHidden(name.toStdString(), hidden); });
  connect(m_rows, &EntryRows::dragged, &edits,
          [&edits](const QString &name, std::size_t place) { edits.moveTo(name.toStdString(), place); });
}

void EntryList::setTheme(const Theme &theme) {
  m_theme = theme;
  m_rows->setTheme(m_theme);
}

void EntryList::followSelection() {
  m_isFollowing = true;
  QItemSelection rows;
  for (const std::string &id : m_selection.ids())
    if (const int row = m_rows->rowOf(id); row >= 0)
      rows.select(m_rows->index(row, 0), m_rows->index(row, EntryRows::columnCountOf - 1));
  selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (!rows.isEmpty()) {
    const QModelIndex last = rows.last().topLeft();
    selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
    scrollTo(m_rows->lastOf(last)); // with what it makes, as far as there is room for both
    scrollTo(last);
  }
  m_isFollowing = false;
}

void EntryList::selectionChanged(const QItemSelection &selected, const QItemSelection &deselected) {
  QTreeView::selectionChanged(selected, deselected);
  if (m_isFollowing)
    return;
  // Those that stay keep their places in the order in which they were chosen.
  std::vector<std::string> ids;
  for (const std::string &id : m_selection.ids())
    if (const int row = m_rows->rowOf(id); row >= 0 && selectionModel()->isRowSelected(row, {}))
      ids.push_back(id);
  for (const QModelIndex &index : selectionModel()->selectedRows())
    if (const std::string &id = m_rows->idIn(index.row()); std::find(ids.begin(), ids.end(), id) == ids.end())
      ids.push_back(id);
  m_selection.set(std::move(ids));
}

std::vector<std::string> EntryList::selectedEntries() const {
  std::vector<std::string> names;
  for (const std::string &id : m_selection.ids())
    if (const std::string name = ownerOf(id); m_model.session().scene.entries.find(name) &&
                                              std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

std::string EntryList::currentEntry() const {
  const std::vector<std::string> names = selectedEntries();
  return names.size() == 1 ? names.front() : std::string();
}

void EntryList::askForLine(const QModelIndex &index) {
  emit lineWanted(QString::fromStdString(ownerOf(m_rows->idIn(index.row()))));
}

void EntryList::keyPressEvent(QKeyEvent *event) {
  const std::string name = currentEntry();
  const bool isAlt = event->modifiers() & Qt::AltModifier;
  if (event->key() == Qt::Key_Delete)
    return m_edits.remove(m_selection.ids());
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && state() != EditingState &&
      currentIndex().isValid())
    return askForLine(currentIndex());
  if (event->key() == Qt::Key_F2 && !name.empty())
    return edit(m_rows->index(m_rows->rowOf(name), EntryRows::Name));
  if (isAlt && !name.empty() && (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down))
    return m_edits.move(name, event->key() == Qt::Key_Up ? -1 : 1);
  QTreeView::keyPressEvent(event);
}

void EntryList::contextMenuEvent(QContextMenuEvent *event) { showMenu(event->globalPos()); }

void EntryList::showMenu(const QPoint &place) {
  auto *menu = new QMenu(this);
  menu->setObjectName("entryMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  fillMenu(*menu);
  if (menu->isEmpty())
    delete menu;
  else
    menu->popup(place);
}

void EntryList::fillMenu(QMenu &menu) {
  const std::vector<std::string> names = selectedEntries();
  if (names.empty())
    return;
  if (const Entry *entry = m_model.session().scene.entries.find(currentEntry())) {
    const std::string name = entry->name;
    const QModelIndex place = m_rows->index(m_rows->rowOf(name), EntryRows::Name);
    menu.addAction(tr("&Edit as a Line"), this, [this, place] { askForLine(place); });
    menu.addAction(tr("&Rename"), this, [this, place] { edit(place); });
    addToggles(menu, *entry);
    addLabelMenu(menu, *entry);
    addColorMenu(menu, *entry);
    addLineMenu(menu, *entry);
    emit menuShown(menu, QString::fromStdString(name));
    menu.addAction(tr("Move &Up"), &m_edits, [this, name] { m_edits.move(name, -1); });
    menu.addAction(tr("Move &Down"), &m_edits, [this, name] { m_edits.move(name, 1); });
    menu.addSeparator();
  }
  menu.addAction(tr("De&lete"), &m_edits, [this, names] { m_edits.remove(names); });
}

void EntryList::addToggles(QMenu &menu, const Entry &entry) {
  if (!isDrawn(entry))
    return;
  const std::string name = entry.name;
  addToggle(menu, tr("&Visible"), !entry.isHidden, [this, name](bool on) { m_edits.setHidden(name, !on); });
  if (std::holds_alternative<Object>(entry.content))
    addToggle(menu, tr("Loc&ked"), entry.isLocked, [this, name](bool on) { m_edits.setLocked(name, on); });
}

void EntryList::addLabelMenu(QMenu &menu, const Entry &entry) {
  if (!isDrawn(entry))
    return;
  QMenu &labels = *menu.addMenu(tr("La&bel"));
  labels.setObjectName("labelMenu");
  Choices choices(labels);
  const std::string name = entry.name;
  const bool isHidden = isLabelHidden(m_model.session().scene.labels, name);
  const auto add = [&](const QString &text, std::optional<LabelText> label) {
    choices.add(text, !isHidden && entry.label == label,
                [this, name, label] { m_edits.setLabel(name, label); });
  };
  add(tr("&Automatic"), {});
  add(tr("&Name"), LabelText::Name);
  add(tr("Name and &Value"), LabelText::Value);
  if (kindOf(entry)) // the marks of a construction have names of their own
    choices.add(tr("N&one"), isHidden, [this, name] { m_edits.hideLabelOf(name); });
}

void EntryList::addColorMenu(QMenu &menu, const Entry &entry) {
  if (!isColored(entry, *m_model.evaluation().find(entry.name)))
    return;
  QMenu &colors = *menu.addMenu(tr("&Colour"));
  colors.setObjectName("colorMenu");
  Choices choices(colors);
  const std::string name = entry.name;
  const auto add = [&](const QString &text, const QIcon &icon, std::optional<Hue> hue) {
    choices.add(text, entry.color == hue, [this, name, hue] { m_edits.setColor(name, hue); }).setIcon(icon);
  };
  add(tr("Automatic"), {}, {});
  for (std::size_t i = 0; i < hueCount; ++i) {
    const auto hue = static_cast<Hue>(i);
    add(titleOf(hue), swatchOf(toQColor(m_theme.colorOf(hue))), hue);
  }
}

void EntryList::addLineMenu(QMenu &menu, const Entry &entry) {
  if (!isLined(entry, *m_model.evaluation().find(entry.name)))
    return;
  QMenu &lines = *menu.addMenu(tr("&Lines"));
  lines.setObjectName("lineMenu");
  Choices choices(lines);
  const std::string name = entry.name;
  const auto add = [&](const QString &text, std::optional<LineStyle> line) {
    choices.add(text, entry.line == line, [this, name, line] { m_edits.setLine(name, line); });
  };
  add(tr("&Automatic"), {});
  add(tr("&Solid"), LineStyle::Solid);
  add(tr("&Dashed"), LineStyle::Dashed);
  add(tr("D&otted"), LineStyle::Dotted);
}

} // namespace halfspace
