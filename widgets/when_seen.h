// What nobody sees need not be made.
#pragma once

#include <QObject>

#include <functional>

class QWidget;

namespace halfspace {

/// Makes what a widget shows: at once where it would be seen, else once it is. A widget is seen, once its
/// window is, where neither it nor what it lies in was hidden on purpose. One that has just been made, and is
/// still to be shown by its layout, counts as seen.
class WhenSeen : public QObject {
  Q_OBJECT
public:
  /// Nothing is made before `renew`. The widget, and what `make` looks at, must outlive it.
  WhenSeen(QWidget &widget, std::function<void()> make);

  /// The widget is to show something else. Whether that is made at once.
  bool renew();

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  void makeIfSeen();

  QWidget &m_widget;
  std::function<void()> m_make;
  bool m_isStale = false; ///< what it shows is not made yet
};

} // namespace halfspace
