// Words in a room that does not grow with them.
#pragma once

#include "widgets/view/wrapped_label.h"

namespace halfspace {

/// A label that takes the room that others leave it. Words that do not fit are cut short, and stand in full
/// where the pointer rests on them.
class FittedLabel : public WrappedLabel {
  Q_OBJECT
public:
  explicit FittedLabel(const char *name);

  /// With indices as `v_d`.
  void setWords(const QString &words);
  /// All of them, however many are shown.
  [[nodiscard]] const QString &words() const { return m_words; }

  [[nodiscard]] QSize sizeHint() const override { return {0, 0}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }
  /// Said always: a QLabel says it only while it has words.
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int) const override { return 0; }

protected:
  void resizeEvent(QResizeEvent *event) override;
  void changeEvent(QEvent *event) override;
  [[nodiscard]] int measuredHeight(int width) override;

private:
  /// Whether words that the label shows have room.
  [[nodiscard]] bool fits() const;
  void fit();
  void showOnly(const QString &words);

  QString m_words;
  QString m_shown; ///< of these words, those that have room
};

} // namespace halfspace
