// What the window tells the user, and asks.
#pragma once

#include <QCoreApplication>
#include <QMessageBox>

namespace halfspace {

class CaseLine;

/// Words in the case line where they can wait, and in a box where they cannot. A value: each part of the
/// window that has something to tell has one. Window and line must outlive it.
class Messages {
  Q_DECLARE_TR_FUNCTIONS(halfspace::Messages)
public:
  Messages(QWidget &window, CaseLine &line) : m_window(&window), m_line(&line) {}

  /// In the line, for a moment.
  void say(const QString &sentence) const;
  /// In the line, as long as it holds; empty: nothing is to be warned of any more.
  void warn(const QString &sentence, const QString &details = {}) const;
  /// In a box, which waits for the user.
  void complain(const QString &sentence) const;
  /// The answer to a question in a box. The usual one is given by Enter; without one the box decides.
  [[nodiscard]] QMessageBox::StandardButton
  ask(QMessageBox::Icon icon, const QString &question, QMessageBox::StandardButtons answers,
      QMessageBox::StandardButton usual = QMessageBox::NoButton) const;

  /// Where boxes of one's own belong.
  [[nodiscard]] QWidget &window() const { return *m_window; }

private:
  QWidget *m_window;
  CaseLine *m_line;
};

} // namespace halfspace
