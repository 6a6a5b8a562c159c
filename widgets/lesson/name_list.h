// A list of names beside what is known of the one that is chosen.
#pragma once

#include <QListWidget>

namespace halfspace {

/// As wide as its widest name, so that each is seen whole.
class NameList : public QListWidget {
  Q_OBJECT
public:
  explicit NameList(QWidget *parent = nullptr);

  /// The name that is chosen stays so; where there is none, or it is gone, the first is. Tells of no change:
  /// what is known of a name may be something else now.
  void setNames(const QStringList &names);
  /// Chooses a name; whether it is there.
  bool choose(const QString &name);

protected:
  void changeEvent(QEvent *event) override;

private:
  void fitWidest();
};

} // namespace halfspace
