// The rows of the list of a scene: its entries, and below each what it makes.
#pragma once

#include "widgets/session_model.h"

#include <QAbstractTableModel>

namespace halfspace {

struct Theme;

/// Follows the scene of a session in Explore; of a lesson there are no rows. What a row tells is made when it
/// is looked at.
class EntryRows : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { Name, Definition, Value, columnCountOf };

  explicit EntryRows(const SessionModel &model, QObject *parent = nullptr);

  /// The theme in whose colours objects are shown; it must outlive the rows.
  void setTheme(const Theme &theme);

  /// The id of the object or the construction in a row: `distance`, `distance.F`.
  [[nodiscard]] const std::string &idIn(int row) const { return m_ids.at(static_cast<std::size_t>(row)); }
  /// −1 for none.
  [[nodiscard]] int rowOf(const std::string &id) const;
  /// The last row of what the entry of a row makes; the row itself where that is nothing.
  [[nodiscard]] QModelIndex lastOf(const QModelIndex &row) const;

  [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
  /// A name is given by the user; the box before it says whether the entry is seen.
  bool setData(const QModelIndex &index, const QVariant &value, int role) override;

  // A row is dragged by its entry's name; it is dropped between rows.
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData *mimeData(const QModelIndexList &indexes) const override;
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  bool dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int column,
                    const QModelIndex &parent) override;

signals:
  void renamed(const QString &name, const QString &newName);
  void hiddenChosen(const QString &name, bool hidden);
  void dragged(const QString &name, std::size_t place); ///< so many entries are to stand above it

private:
  void takeScene();
  [[nodiscard]] const Entry *entryIn(int row) const; ///< null for what an entry makes
  /// How many entries have their rows above this one.
  [[nodiscard]] std::size_t entriesAbove(int row) const;
  [[nodiscard]] QString textIn(const QModelIndex &index) const;
  [[nodiscard]] QString tipIn(int row) const;
  /// What the object of a row is drawn as: one of this kind, or the mark of a construction.
  [[nodiscard]] std::optional<Subject> subjectIn(int row, const Kind &kind) const;
  [[nodiscard]] QVariant swatchIn(int row) const;

  const SessionModel &m_model;
  const Theme *m_theme;
  std::vector<std::string> m_ids;
};

} // namespace halfspace
