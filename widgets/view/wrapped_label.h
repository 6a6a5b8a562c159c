// Words in rows.
#pragma once

#include <QLabel>

namespace halfspace {

/// A label whose words go on in the next row where the width ends, and begin where those of others do.
class WrappedLabel : public QLabel {
  Q_OBJECT
public:
  explicit WrappedLabel(const char *name, QWidget *parent = nullptr);

  /// The height that all words need. Measured once for a width, type and style, until it is forgotten.
  [[nodiscard]] int heightIn(int width);

protected:
  void changeEvent(QEvent *event) override;
  /// Measures the height that all words need.
  [[nodiscard]] virtual int measuredHeight(int width) { return heightForWidth(width); }
  /// The words are others now.
  void forgetHeight() { m_measured = {}; }

  /// Whether words look different after an event.
  [[nodiscard]] static bool changesType(const QEvent &event);

private:
  QSize m_measured; ///< invalid: nobody has asked
};

} // namespace halfspace
