// What stands in a worked line in place of its numbers.
#pragma once

#include <QWidget>

class QLineEdit;

namespace halfspace {

/// A field for the learner's answer, and the button that shows the line instead. Lines whose numbers are no
/// single number have the button alone.
class BlankField : public QWidget {
  Q_OBJECT
public:
  BlankField(const QString &question, bool asksForNumber, QWidget *parent = nullptr);

  /// What was said about the last answer; empty while nothing is.
  void setRemark(const QString &remark);

signals:
  void answered(const QString &text); ///< with a decimal point, whatever the language writes
  void showRequested();

private:
  void answer();
  void mark(bool wrong);

  QLineEdit *m_edit = nullptr; ///< null where there is only the button
};

} // namespace halfspace
