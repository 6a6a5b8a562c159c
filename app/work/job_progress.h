// How far something is that goes on beside the window.
#pragma once

#include <QPointer>
#include <QProgressDialog>

#include <functional>

namespace halfspace {

/// A bar with a way to cancel, in a window of its own. What takes only a moment shows none.
class JobProgress {
public:
  /// `name`: the object's; `cancel` is called when the user wants that.
  JobProgress(QWidget &window, QString name, QString title, std::function<void()> cancel);
  ~JobProgress();
  JobProgress(const JobProgress &) = delete;
  JobProgress &operator=(const JobProgress &) = delete;

  /// A part from 0 to 1, or below 0 where that is not known, and what is being done.
  void show(double part, const QString &what);
  /// It is over, or another begins.
  void end();

private:
  void open();

  QWidget &m_window;
  QString m_name;
  QString m_title;
  std::function<void()> m_cancel;
  QPointer<QProgressDialog> m_dialog; ///< the window's; null while nothing is shown
};

} // namespace halfspace
