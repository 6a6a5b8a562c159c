// What is said of the nearest special case, and the ways there.
#pragma once

#include <QWidget>

#include <vector>

class QMenu;
class QPushButton;

namespace halfspace {

class FittedLabel;

/// A special case near the present one.
struct NearbyCase {
  QString words;             ///< "The ray would run parallel to the plane."
  bool canBeReached = false; ///< by numbers without roots
  bool operator==(const NearbyCase &) const = default;
};

/// A row with words, a button that leads to the nearest case, one with a menu of all, and one that leads back
/// to the start.
class NearbyOffer : public QWidget {
  Q_OBJECT
public:
  explicit NearbyOffer(QWidget *parent = nullptr);

  /// What is said, empty for nothing, and the cases that there are, the nearest first. Those that can be
  /// reached are offered.
  void setCases(const QString &words, const std::vector<NearbyCase> &cases);
  void offerAfresh(bool offered);
  [[nodiscard]] bool offersAfresh() const;

  [[nodiscard]] int heightOfButtons() const;
  /// In a width that leaves the words too little room they are hidden.
  void fitInto(int width);

signals:
  void chosen(int which); ///< the learner wants to be taken to a special case
  void afreshChosen();    ///< … or back to the start
  void changed();         ///< other buttons are there

private:
  void offer();
  void fillMenu();

  FittedLabel *m_words;
  QPushButton *m_there;  ///< leads to the nearest
  QPushButton *m_others; ///< opens a menu of all
  QMenu *m_all;          ///< filled when it is opened
  QPushButton *m_afresh; ///< leads back to the start
  std::vector<NearbyCase> m_cases;
};

} // namespace halfspace
