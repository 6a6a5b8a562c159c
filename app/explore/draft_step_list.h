// The steps of a lesson, while somebody makes it.
#pragma once

#include <QWidget>

class QListWidget;
class QPushButton;

namespace halfspace {

/// The titles of the steps, one of them chosen, and buttons that add one behind it, take it away and move it.
/// It says what is wanted of it, and is told what there is.
class DraftStepList : public QWidget {
  Q_OBJECT
public:
  DraftStepList();

  /// Shows steps, of which there is one at least, and chooses one.
  void show(const QStringList &titles, int chosen);
  void setTitle(int step, const QString &title);

signals:
  void chosen(int step);
  void addWanted();
  void removeWanted();
  void moveWanted(int places); ///< up or down

private:
  /// Leaves out what cannot be done with the chosen one.
  void enable();

  QListWidget *m_list;
  QPushButton *m_remove;
  QPushButton *m_up;
  QPushButton *m_down;
};

} // namespace halfspace
