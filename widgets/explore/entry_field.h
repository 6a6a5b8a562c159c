// The field in which lines of a scene are typed.
#pragma once

#include <QLineEdit>

#include <optional>

namespace halfspace {

/// A line of text of which a part can be marked as wrong. Keys that lead out of it are told, not taken.
class EntryField : public QLineEdit {
  Q_OBJECT
public:
  explicit EntryField(QWidget *parent = nullptr);

  /// A part of the text; of no length: a place where something is missing.
  struct Part {
    int begin = 0;
    int length = 0;
  };
  /// Draws a wavy line below a part, until the text changes; nothing: below none.
  void setFault(const std::optional<Part> &part);
  [[nodiscard]] const std::optional<Part> &fault() const { return m_fault; }
  /// Whether there is a suggestion for Tab to take; else it leads to the next widget.
  void setCanComplete(bool can) { m_canComplete = can; }
  void setFaultInk(const QColor &ink) { m_faultInk = ink; }

signals:
  void stepped(int rows); ///< to the suggestion above, −1, or below, 1
  void completing();      ///< Tab: the suggestion is to be taken into the text
  void entering();
  void dismissed();                       ///< Escape
  void linesPasted(const QString &lines); ///< several at once: they are not in the field

protected:
  bool event(QEvent *event) override;
  void paintEvent(QPaintEvent *event) override;
  void focusOutEvent(QFocusEvent *event) override;

private:
  [[nodiscard]] bool takeKey(int key);
  /// Where a character begins, in pixels of the widget.
  [[nodiscard]] double placeOf(int character) const;

  bool m_canComplete = false;
  std::optional<Part> m_fault;
  QColor m_faultInk = Qt::red;
};

} // namespace halfspace
