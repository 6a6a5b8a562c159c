// What the scene comes to, in a line of words below it.
#pragma once

#include <QTimer>
#include <QWidget>

#include <chrono>

class QLabel;
class QPushButton;
class QStackedLayout;

namespace halfspace {

/// The case in plain words; in its place, for a moment, what the program has to tell, and beside both, as
/// long as it holds, what it has to complain of. Below them the nearest special case, with a way there.
/// As long as width and type are the same it only grows: the picture above it would jump with the words.
class CaseLine : public QWidget {
  Q_OBJECT
public:
  static constexpr std::chrono::milliseconds usualReadingTime{8000};
  /// What it says stands there for `readingTime`.
  explicit CaseLine(std::chrono::milliseconds readingTime = usualReadingTime, QWidget *parent = nullptr);

  /// `degenerate`: the words are a warning.
  void setCase(const QString &words, bool degenerate);
  /// The nearest special case in words, empty for none; where it can be reached, with a button that says
  /// `nearbyChosen`.
  void setNearby(const QString &words, bool canBeReached);
  void say(const QString &sentence);
  /// Where the case is what counts, as in a drag.
  void endMessage();
  /// Empty: there is nothing to complain of.
  void complain(const QString &sentence, const QString &details = {});

signals:
  void nearbyChosen(); ///< the learner wants to be taken to the nearest special case

protected:
  void resizeEvent(QResizeEvent *event) override;
  void changeEvent(QEvent *event) override;

private:
  QLabel *m_case;
  QLabel *m_message;
  QLabel *m_usual; ///< as long as cases usually are; never shown
  QLabel *m_nearby;
  QPushButton *m_there; ///< leads to it
  QLabel *m_complaint;
  QStackedLayout *m_words; ///< case and message, one at a time
  QTimer m_messageTimer;
};

} // namespace halfspace
