// A list of things with ticks.
#pragma once

#include <QWidget>

#include <string>
#include <vector>

class QListWidget;

namespace halfspace {

/// Something that can be ticked, with what it is called in the list.
struct CheckItem {
  std::string name;
  QString words;
};

/// Things under a heading, each ticked or not.
class CheckList : public QWidget {
  Q_OBJECT
public:
  CheckList(const QString &heading, const std::vector<CheckItem> &items);

  /// Ticks those of these names, and no others.
  void setChecked(const std::vector<std::string> &names);
  /// In the order of the list.
  [[nodiscard]] std::vector<std::string> checked() const;

signals:
  void changed();

private:
  QListWidget *m_list;
  std::vector<CheckItem> m_items;
};

} // namespace halfspace
