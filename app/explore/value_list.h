// The values of a scene, to be put into what somebody writes.
#pragma once

#include <QComboBox>

#include <string>

namespace halfspace {

/// Opens to a list of which one value is taken at a time; closed it always reads “Values”.
class ValueList : public QComboBox {
  Q_OBJECT
public:
  ValueList();

  /// `text` tells people of the value that goes by a name.
  void add(const QString &text, const std::string &name);

  /// As wide as the longest text, however narrow the closed list is.
  void showPopup() override;

signals:
  void taken(const QString &name);
};

} // namespace halfspace
