// Somebody who answers a message box that is waited for.
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QMessageBox>
#include <QTimer>

#include <utility>

namespace halfspace {

/// Presses a button of the next message box, by its text, or closes the box where it has none such; and keeps
/// what the box said.
class BoxAnswerer : public QObject {
public:
  explicit BoxAnswerer(QString button = {}) : m_button(std::move(button)) {
    m_timer.setInterval(20);
    QObject::connect(&m_timer, &QTimer::timeout, this, [this] { answer(); });
    m_timer.start();
  }

  QString text; ///< empty as long as no box was there

private:
  void answer() {
    auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
    if (!box)
      return;
    m_timer.stop();
    text = box->text();
    for (QAbstractButton *button : box->buttons())
      if (button->text().remove('&') == m_button)
        return button->click();
    box->reject();
  }

  QString m_button;
  QTimer m_timer;
};

} // namespace halfspace
