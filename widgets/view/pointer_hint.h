// Words beside the pointer.
#pragma once

#include <QLabel>

namespace halfspace {

/// A label over a widget that goes with the pointer and takes no events. It stays within the widget.
class PointerHint : public QLabel {
  Q_OBJECT
public:
  explicit PointerHint(QWidget &over);

  /// Says something beside a place of the widget; nothing with no words.
  void showAt(const QPoint &place, const QString &words);
};

} // namespace halfspace
