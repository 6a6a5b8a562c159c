// The application, with an end in order for what nobody expected.
#pragma once

#include <QApplication>

#include <functional>

namespace halfspace {

/// An exception that comes out of an event is said on standard error, the last deed is done, and the event
/// loop ends with exitRefused.
class Application : public QApplication {
  Q_OBJECT
public:
  using QApplication::QApplication;

  /// What is to be done before such an end; an exception of its own ends it.
  void setLastDeed(std::function<void()> deed) { m_lastDeed = std::move(deed); }

  bool notify(QObject *receiver, QEvent *event) override;

private:
  void endAfter(const std::exception &exception);

  std::function<void()> m_lastDeed;
  bool m_isEnding = false;
};

} // namespace halfspace
