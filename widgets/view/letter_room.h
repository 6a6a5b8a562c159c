// How much room words of a usual length need.
#pragma once

#include <QLabel>

namespace halfspace {

/// Is as high as so many letters would be, and is never seen. It is a label because labels of its name have a
/// look.
class LetterRoom : public QLabel {
  Q_OBJECT
public:
  LetterRoom(const char *name, QWidget *parent);

  /// Letters with indices, which make rows higher, in so many rows where they fit.
  void setLetters(int letters, int rows);
  /// Measured once for a width.
  [[nodiscard]] int heightIn(int width);

protected:
  void changeEvent(QEvent *event) override;

private:
  QSize m_measured; ///< invalid: nobody has asked
};

} // namespace halfspace
