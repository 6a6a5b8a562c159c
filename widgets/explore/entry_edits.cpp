#include "widgets/explore/entry_edits.h"

#include "lessons/scene/scene_looks.h"
#include "widgets/picture/hand/label_hand.h"

#include <algorithm>

namespace halfspace {
namespace {

QString text(const std::string &name) { return QString::fromStdString(name); }

QString listed(const std::vector<std::string> &names) {
  QStringList list;
  for (const std::string &name : names)
    list << text(name);
  return list.join(", ");
}

} // namespace

bool EntryEdits::edit(const std::vector<Edit> &edits, const QString &description) {
  const QString refused =
      m_model.history().editTogether(keepingColors(m_model.session().scene, edits), description);
  if (!refused.isEmpty())
    emit told(refused);
  return refused.isEmpty();
}

Entry EntryEdits::entryNamed(const std::string &name) const {
  return *m_model.session().scene.entries.find(name);
}

bool EntryEdits::add(const Entry &entry) {
  return edit({AddEntry{m_model.session().scene.entries.size(), entry}}, tr("Add %1").arg(text(entry.name)));
}

bool EntryEdits::addAll(const std::vector<Entry> &entries) {
  std::vector<Edit> edits;
  edits.reserve(entries.size());
  for (const Entry &entry : entries)
    edits.emplace_back(AddEntry{m_model.session().scene.entries.size() + edits.size(), entry});
  return edit(edits, tr("Add %n entries", nullptr, static_cast<int>(entries.size())));
}

bool EntryEdits::replace(const std::string &name, const Entry &entry) {
  return edit({ReplaceEntry{name, entry}}, tr("Change %1").arg(text(name)));
}

bool EntryEdits::rename(const std::string &name, const std::string &newName) {
  return edit({RenameEntry{name, newName}}, tr("Call %1 %2").arg(text(name), text(newName)));
}

void EntryEdits::remove(const std::vector<std::string> &ids) {
  std::vector<std::string> names; // each once, as an entry makes several objects
  for (const std::string &id : ids)
    if (std::find(names.begin(), names.end(), ownerOf(id)) == names.end())
      names.push_back(ownerOf(id));
  std::vector<Edit> edits;
  std::vector<std::string> gone;   // also with one above it
  std::vector<std::string> others; // that nobody chose
  for (const std::string &name : names) {
    if (std::find(gone.begin(), gone.end(), name) != gone.end())
      continue;
    edits.emplace_back(RemoveEntry{name, true});
    gone.push_back(name);
    for (const std::string &dependent : dependentsOf(m_model.session().scene, name))
      if (std::find(gone.begin(), gone.end(), dependent) == gone.end()) {
        gone.push_back(dependent);
        if (std::find(names.begin(), names.end(), dependent) == names.end())
          others.push_back(dependent);
      }
  }
  if (!edits.empty() && edit(edits, tr("Delete %1").arg(listed(names))) && !others.empty())
    emit told(
        tr("With %1 went what was made of it: %2. Undo brings all back.").arg(listed(names), listed(others)));
}

void EntryEdits::move(const std::string &name, int places) {
  const int to = static_cast<int>(*m_model.session().scene.entries.placeOf(name)) + places;
  if (to >= 0)
    moveTo(name, static_cast<std::size_t>(to));
}

void EntryEdits::moveTo(const std::string &name, std::size_t place) {
  const auto &entries = m_model.session().scene.entries;
  const std::size_t to = std::min(place, entries.size() - 1);
  if (to != entries.placeOf(name))
    edit({MoveEntry{name, to}}, tr("Move %1 in the list").arg(text(name)));
}

bool EntryEdits::changeLook(const Entry &changed, const QString &description) {
  return edit({ReplaceEntry{changed.name, changed}}, description);
}

void EntryEdits::setHidden(const std::string &name, bool hidden) {
  Entry entry = entryNamed(name);
  entry.isHidden = hidden;
  changeLook(entry, (hidden ? tr("Hide %1") : tr("Show %1")).arg(text(name)));
}

void EntryEdits::setLocked(const std::string &name, bool locked) {
  Entry entry = entryNamed(name);
  entry.isLocked = locked;
  changeLook(entry, (locked ? tr("Lock %1") : tr("Unlock %1")).arg(text(name)));
}

void EntryEdits::setColor(const std::string &name, std::optional<Hue> color) {
  Entry entry = entryNamed(name);
  entry.color = color;
  changeLook(entry, tr("Colour %1").arg(text(name)));
}

void EntryEdits::setLine(const std::string &name, std::optional<LineStyle> line) {
  Entry entry = entryNamed(name);
  entry.line = line;
  changeLook(entry, tr("Lines of %1").arg(text(name)));
}

void EntryEdits::setLabel(const std::string &name, std::optional<LabelText> label) {
  const Scene &scene = m_model.session().scene;
  Entry entry = entryNamed(name);
  entry.label = label;
  std::vector<Edit> edits{ReplaceEntry{name, entry}};
  if (isLabelHidden(scene.labels, name))
    edits.emplace_back(hideLabel(scene, name, false));
  edit(edits, tr("Label of %1").arg(text(name)));
}

void EntryEdits::hideLabelOf(const std::string &name) {
  edit({hideLabel(m_model.session().scene, name, true)}, tr("Hide the label of %1").arg(text(name)));
}

} // namespace halfspace
