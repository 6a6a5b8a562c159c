#include "widgets/explore/entry_rows.h"

#include "lessons/language.h"
#include "lessons/object/kind.h"
#include "lessons/scene/offered_objects.h"
#include "lessons/typed/entry_summary.h"
#include "widgets/colors.h"
#include "widgets/explore/swatch.h"
#include "widgets/picture/theme.h"

#include <QMimeData>

#include <algorithm>

namespace halfspace {
namespace {

/// What an entry makes stands below it, a little to the right.
constexpr const char *indent = "    ";

constexpr const char *entryMimeType = "application/x-halfspace-entry";

bool isMade(const std::string &id) { return id.find('.') != std::string::npos; }

std::vector<std::string> idsIn(const Evaluation &evaluation) {
  std::vector<std::string> ids;
  for (const EvaluatedEntry &entry : evaluation.entries) {
    ids.push_back(entry.name);
    if (entry.isConstruction())
      for (const OfferedObject &made : entry.offers)
        ids.push_back(entry.name + "." + made.name);
  }
  return ids;
}

} // namespace

EntryRows::EntryRows(const SessionModel &model, QObject *parent)
    : QAbstractTableModel(parent), m_model(model), m_theme(&themes().front()) {
  connect(&model, &SessionModel::outcomeChanged, this, &EntryRows::takeScene);
  takeScene();
}

void EntryRows::setTheme(const Theme &theme) {
  m_theme = &theme;
  takeScene();
}

void EntryRows::takeScene() {
  // In lessons nobody sees the list, and their drags need not wait for it.
  std::vector<std::string> ids =
      isExplore(m_model) ? idsIn(m_model.evaluation()) : std::vector<std::string>();
  if (ids != m_ids) {
    beginResetModel();
    m_ids = std::move(ids);
    endResetModel();
  } else if (!m_ids.empty()) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCountOf - 1));
  }
}

int EntryRows::rowOf(const std::string &id) const {
  const auto found = std::find(m_ids.begin(), m_ids.end(), id);
  return found == m_ids.end() ? -1 : static_cast<int>(found - m_ids.begin());
}

QModelIndex EntryRows::lastOf(const QModelIndex &row) const {
  int last = row.row();
  while (last + 1 < rowCount() && isMade(idIn(last + 1)))
    ++last;
  return row.siblingAtRow(last);
}

int EntryRows::rowCount(const QModelIndex &parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_ids.size());
}

int EntryRows::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : columnCountOf; }

const Entry *EntryRows::entryIn(int row) const { return m_model.session().scene.entries.find(idIn(row)); }

QVariant EntryRows::data(const QModelIndex &index, int role) const {
  const Entry *entry = entryIn(index.row());
  switch (role) {
  case Qt::DisplayRole:
    return textIn(index);
  case Qt::EditRole:
    return entry ? QVariant(QString::fromStdString(entry->name)) : QVariant();
  case Qt::ToolTipRole:
  case Qt::AccessibleDescriptionRole:
    return tipIn(index.row());
  case Qt::DecorationRole:
    return index.column() == Name ? swatchIn(index.row()) : QVariant();
  case Qt::CheckStateRole:
    return index.column() == Name && entry && isDrawn(*entry)
               ? QVariant(entry->isHidden ? Qt::Unchecked : Qt::Checked)
               : QVariant();
  default:
    return {};
  }
}

QString EntryRows::textIn(const QModelIndex &index) const {
  const std::string &id = idIn(index.row());
  const Evaluation &evaluation = m_model.evaluation();
  if (const Entry *entry = entryIn(index.row())) {
    if (index.column() == Name)
      return QString::fromStdString(entry->name);
    const EntrySummary summary = summaryOf(*entry, evaluation, language().decimalMark);
    return QString::fromStdString(index.column() == Definition ? summary.definition : summary.value);
  }
  const OfferedObject *made = findOffered(evaluation, id);
  switch (index.column()) {
  case Name:
    return QString(indent) + QString::fromStdString(id);
  case Definition:
    return made ? QString::fromStdString(made->given->object.kind().noun()) : QString();
  default:
    return made ? QString::fromStdString(valueOf(*made)) : QString();
  }
}

QString EntryRows::tipIn(int row) const {
  const EvaluatedEntry *evaluated = m_model.evaluation().find(idIn(row));
  if (!evaluated) {
    const OfferedObject *made = findOffered(m_model.evaluation(), idIn(row));
    return made ? QString::fromStdString(made->whyNot) : QString();
  }
  if (const std::string &told = evaluated->outcome->told->description; !told.empty())
    return QString::fromStdString(told);
  return QString::fromStdString(evaluated->looksAt.front()->object.kind().noun());
}

std::optional<Subject> EntryRows::subjectIn(int row, const Kind &kind) const {
  const std::string &id = idIn(row);
  if (!isMade(id))
    return kind.subject;
  const Mark *mark = findMark(*m_model.evaluation().find(ownerOf(id))->outcome->figure, id);
  return mark ? std::optional(baseOf(*mark).subject) : std::nullopt;
}

QVariant EntryRows::swatchIn(int row) const {
  const OfferedObject *object = findOffered(m_model.evaluation(), idIn(row));
  if (!object)
    return {}; // of a construction: what it makes has its colours
  const std::optional<Subject> subject = subjectIn(row, object->given->object.kind());
  const Look &look = object->given->look;
  const auto hue = look.hue ? look.hue : subject ? std::optional(hueOf(*subject)) : std::nullopt;
  return hue ? QVariant(swatchOf(toQColor(m_theme->colorOf(*hue)))) : QVariant();
}

QVariant EntryRows::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal)
    return {};
  return section == Name ? tr("Name") : section == Definition ? tr("What it is") : tr("Value");
}

Qt::ItemFlags EntryRows::flags(const QModelIndex &index) const {
  if (!index.isValid())
    return Qt::ItemIsDropEnabled; // between the rows
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  if (isMade(idIn(index.row())))
    return flags;
  flags |= Qt::ItemIsDragEnabled;
  if (index.column() == Name)
    flags |= Qt::ItemIsEditable | Qt::ItemIsUserCheckable;
  return flags;
}

bool EntryRows::setData(const QModelIndex &index, const QVariant &value, int role) {
  const QString name = QString::fromStdString(idIn(index.row()));
  if (role == Qt::CheckStateRole)
    emit hiddenChosen(name, value.toInt() == Qt::Unchecked);
  else if (role == Qt::EditRole && value.toString() != name)
    emit renamed(name, value.toString().trimmed());
  return false; // the row follows the scene
}

QStringList EntryRows::mimeTypes() const { return {entryMimeType}; }

QMimeData *EntryRows::mimeData(const QModelIndexList &indexes) const {
  const auto isOfFirst = [&](const QModelIndex &index) { return index.row() == indexes.front().row(); };
  if (!std::all_of(indexes.begin(), indexes.end(), isOfFirst) || indexes.isEmpty())
    return nullptr;           // several rows have no one place where they could go
  auto *data = new QMimeData; // it is the caller's
  data->setData(entryMimeType, QByteArray::fromStdString(idIn(indexes.front().row())));
  return data;
}

std::size_t EntryRows::entriesAbove(int row) const {
  return static_cast<std::size_t>(
      std::count_if(m_ids.begin(), m_ids.begin() + row, [](const std::string &id) { return !isMade(id); }));
}

bool EntryRows::dropMimeData(const QMimeData *data, Qt::DropAction, int row, int, const QModelIndex &) {
  const std::string name = data->data(entryMimeType).toStdString();
  const auto from = m_model.session().scene.entries.placeOf(name);
  if (!from)
    return false;
  const std::size_t above = entriesAbove(row < 0 ? rowCount() : row); // below all rows there is no row
  emit dragged(QString::fromStdString(name), *from < above ? above - 1 : above);
  return false; // the rows follow the scene
}

} // namespace halfspace
