// What the scene comes to, in a line of words below it.
#pragma once

#include <QTimer>
#include <QWidget>

#include <chrono>

class QLabel;
class QStackedLayout;

namespace halfspace {

/// The case in plain words; in its place, for a moment, what the program has to tell, and beside both, as
/// long as it holds, what it has to complain of.
class CaseLine : public QWidget {
  Q_OBJECT
public:
  static constexpr std::chrono::milliseconds usualReadingTime{8000};
  /// What it says stands there for `readingTime`.
  explicit CaseLine(std::chrono::milliseconds readingTime = usualReadingTime, QWidget *parent = nullptr);

  /// `degenerate`: the words are a warning.
  void setCase(const QString &words, bool degenerate);
  /// While the line is held it only grows: the picture above it would jump back and forth with the numbers.
  /// The case is what counts then: a message goes.
  void setHeld(bool held);
  void say(const QString &sentence);
  /// Empty: there is nothing to complain of.
  void complain(const QString &sentence, const QString &details = {});

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  void endMessage();

  bool m_held = false;
  QLabel *m_case;
  QLabel *m_message;
  QLabel *m_usual; ///< as long as cases usually are; never shown
  QLabel *m_complaint;
  QStackedLayout *m_words; ///< case and message, one at a time
  QTimer m_messageTimer;
};

} // namespace halfspace
