// How much room words of a usual length need.
#pragma once

#include "widgets/view/wrapped_label.h"

namespace halfspace {

/// Is as high as so many letters would be, and is never seen. It is a label because labels of its name have a
/// look.
class LetterRoom : public WrappedLabel {
  Q_OBJECT
public:
  LetterRoom(const char *name, QWidget *parent);

  /// Letters with indices, which make rows higher, in so many rows where they fit.
  void setLetters(int letters, int rows);
};

} // namespace halfspace
