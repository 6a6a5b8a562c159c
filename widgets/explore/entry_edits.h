// What can be done to an entry of a scene in its list.
#pragma once

#include "widgets/session_model.h"

namespace halfspace {

/// Edits of the session, each an undo step with a name of its own. What is refused is told, and leaves the
/// scene as it was. The model must outlive it.
class EntryEdits : public QObject {
  Q_OBJECT
public:
  explicit EntryEdits(SessionModel &model, QObject *parent = nullptr) : QObject(parent), m_model(model) {}

  /// Puts an entry below all others. False where it is refused.
  bool add(const Entry &entry);
  /// … several, in their order, as one step.
  bool addAll(const std::vector<Entry> &entries);
  /// Puts an entry in the place of the one of this name, which need not be its own.
  bool replace(const std::string &name, const Entry &entry);
  bool rename(const std::string &name, const std::string &newName);
  /// Takes away the entries of these objects, and with them what looks at them.
  void remove(const std::vector<std::string> &ids);
  /// By so many places, down or up.
  void move(const std::string &name, int places);
  /// So that so many entries stand above it; at most below all others.
  void moveTo(const std::string &name, std::size_t place);
  void setHidden(const std::string &name, bool hidden);
  void setLocked(const std::string &name, bool locked);
  /// Nothing: the scene decides.
  void setColor(const std::string &name, std::optional<Hue> color);
  void setLine(const std::string &name, std::optional<LineStyle> line);
  /// What its labels say; one of its own mark that was hidden is seen again. Nothing: the scene decides.
  void setLabel(const std::string &name, std::optional<LabelText> text);
  /// Of the entry's own mark.
  void hideLabelOf(const std::string &name);

signals:
  void told(const QString &sentence); ///< why something is refused, or what was done besides

private:
  bool edit(const std::vector<Edit> &edits, const QString &description);
  /// The entry of this name as it is, to be changed; requires one.
  [[nodiscard]] Entry entryNamed(const std::string &name) const;
  /// Changes what is drawn of an entry.
  bool changeLook(const Entry &changed, const QString &description);

  SessionModel &m_model;
};

} // namespace halfspace
