// What stands in a worked line in place of its numbers.
#pragma once

#include <QWidget>

class QLineEdit;
class QToolButton;

namespace halfspace {

/// A field for the learner's answer, and beside it the button that shows the line instead. The keys that go
/// from step to step are the window's here too, and Escape hands the keys to what it stands in.
class BlankField : public QWidget {
  Q_OBJECT
public:
  /// With room for so many letters, or for fewer where there is less.
  explicit BlankField(int letters, QWidget *parent = nullptr);

  /// What is asked for, for screen readers.
  void setQuestion(const QString &question);

  /// What was said about the last answer; empty while nothing is.
  void setRemark(const QString &remark);

  [[nodiscard]] QSize sizeHint() const override;

signals:
  void answered(const QString &text); ///< as it was typed
  void showRequested();

protected:
  void changeEvent(QEvent *event) override;
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  void setWidths();
  void leave();
  void answer();
  void mark(bool wrong);

  int m_letters;
  QLineEdit *m_edit;
  QToolButton *m_show;
};

} // namespace halfspace
