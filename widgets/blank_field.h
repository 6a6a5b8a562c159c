// What stands in a worked line in place of its numbers.
#pragma once

#include <QWidget>

class QLineEdit;

namespace halfspace {

/// A field for the learner's answer, and the button that shows the line instead.
class BlankField : public QWidget {
  Q_OBJECT
public:
  /// `numbers` is how many are asked for: 0 where nothing can be typed.
  BlankField(const QString &question, std::size_t numbers, QWidget *parent = nullptr);

  /// What was said about the last answer; empty while nothing is.
  void setRemark(const QString &remark);

signals:
  void answered(const QString &text); ///< with a decimal point, whatever the language writes
  void showRequested();

private:
  void ask(QLineEdit &edit, const QString &question);
  void answer();
  void mark(bool wrong);

  QLineEdit *m_edit = nullptr; ///< null where nothing can be typed
};

} // namespace halfspace
