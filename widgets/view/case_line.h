// What the scene comes to, in a line of words below it.
#pragma once

#include <QTimer>
#include <QWidget>

#include <chrono>
#include <vector>

class QLabel;
class QMenu;
class QPushButton;
class QStackedLayout;

namespace halfspace {

class FittedLabel;

/// A special case near the present one.
struct NearbyCase {
  QString words;             ///< "The ray would run parallel to the plane."
  bool canBeReached = false; ///< by numbers without roots
  bool operator==(const NearbyCase &) const = default;
};

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
  void setNearby(const QString &words, const std::vector<NearbyCase> &cases);
  /// Where the present case lacks what the step speaks of: offers to go back to where it begins.
  void offerAfresh(bool offered);
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
  [[nodiscard]] QWidget *createNearbyRow();
  [[nodiscard]] QWidget *createColumn();
  void offer(const std::vector<NearbyCase> &cases);
  /// Shares the room between the case and what stands below it.
  void share();
  [[nodiscard]] bool hasRoomForNearbyWords() const;

  FittedLabel *m_case;
  QLabel *m_message;
  FittedLabel *m_nearby;
  QWidget *m_column = nullptr; ///< of all these
  // Never seen: as high as the room that there is to be.
  QLabel *m_roomOfCase;
  QLabel *m_roomOfNearby;
  int m_most = 0;        ///< in pixels, but for messages
  QPushButton *m_there;  ///< leads to the nearest
  QPushButton *m_others; ///< opens a menu of all
  QMenu *m_all;
  QPushButton *m_afresh; ///< leads back to the start
  std::vector<NearbyCase> m_cases;
  QLabel *m_complaint;
  QWidget *m_second = nullptr;       ///< what is near, and a message, one at a time
  QStackedLayout *m_pages = nullptr; ///< of these two
  QTimer m_messageTimer;
};

} // namespace halfspace
