// What the scene comes to, in a line of words below it.
#pragma once

#include "widgets/view/nearby_offer.h"

#include <QTimer>

#include <chrono>

class QLabel;
class QStackedLayout;

namespace halfspace {

class FittedLabel;
class LetterRoom;

/// The case in plain words, and beside it, as long as it holds, what the program has to complain of. Below
/// them the nearest special case, with a way there and to the others; in its place, for a moment, what the
/// program has to tell. As long as window and type are the same it keeps its height: the picture above it
/// would jump with the words. Only a message of several rows, or a complaint, makes it higher. The case is
/// what counts: a long one takes the place of what is near, and a narrow line has the buttons of that without
/// its words. More words than there is room for are cut short, and stand in full where the pointer rests on
/// them; but a message is as high as it needs.
class CaseLine : public QWidget {
  Q_OBJECT
public:
  static constexpr std::chrono::milliseconds usualReadingTime{8000};
  /// What it says stands there for `readingTime`.
  explicit CaseLine(std::chrono::milliseconds readingTime = usualReadingTime, QWidget *parent = nullptr);

  /// In a high window its words have more room: the case is the one sentence that all in a class should read.
  /// It is never higher than a quarter of the window.
  void setWindowHeight(int height);
  /// `degenerate`: the words are a warning.
  void setCase(const QString &words, bool degenerate);
  /// What is said of the nearest special case, empty for none, and all that there are, the nearest first.
  /// Those that can be reached are offered.
  void setNearby(const QString &words, const std::vector<NearbyCase> &cases) {
    m_nearby->setCases(words, cases);
  }
  /// Where the present case lacks what the step speaks of: offers to go back to where it begins.
  void offerAfresh(bool offered) { m_nearby->offerAfresh(offered); }
  void say(const QString &sentence);
  /// Where the case is what counts, as in a drag.
  void endMessage();
  /// Empty: there is nothing to complain of.
  void complain(const QString &sentence, const QString &details = {});

signals:
  void nearbyChosen(int which); ///< the learner wants to be taken to a special case
  void afreshChosen();          ///< … or back to the start

protected:
  bool event(QEvent *event) override;

private:
  [[nodiscard]] QWidget *createColumn();
  /// Shares the room between the case and what stands below it.
  void share();

  FittedLabel *m_case;
  QLabel *m_message;
  NearbyOffer *m_nearby;
  QWidget *m_column = nullptr; ///< of all these
  // As high as the room that there is to be.
  LetterRoom *m_roomOfCase;
  LetterRoom *m_roomOfNearby;
  int m_most = 0; ///< in pixels, but for messages
  QLabel *m_complaint;
  QWidget *m_second = nullptr;       ///< what is near, and a message, one at a time
  QStackedLayout *m_pages = nullptr; ///< of these two
  QTimer m_messageTimer;
};

} // namespace halfspace
