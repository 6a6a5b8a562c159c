// What is selected of a scene, in its list and in its picture alike.
#pragma once

#include <QObject>

#include <string>
#include <vector>

namespace halfspace {

/// The ids of objects and constructions, `Q`, `distance` or `distance.F`, in the order in which they were
/// chosen. Who shows a scene follows it, and forgets what goes.
class SceneSelection : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  [[nodiscard]] const std::vector<std::string> &ids() const { return m_ids; }
  [[nodiscard]] bool contains(const std::string &id) const;
  void set(std::vector<std::string> ids);
  /// Adds it behind the others, or takes it out.
  void toggle(const std::string &id);

signals:
  void changed();

private:
  std::vector<std::string> m_ids;
};

} // namespace halfspace
