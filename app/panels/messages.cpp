#include "app/panels/messages.h"

#include "widgets/view/case_line.h"

namespace halfspace {

void Messages::say(const QString &sentence) const { m_line->say(sentence); }

void Messages::warn(const QString &sentence, const QString &details) const {
  m_line->complain(sentence, details);
}

void Messages::complain(const QString &sentence) const {
  static_cast<void>(ask(QMessageBox::Warning, sentence, QMessageBox::Ok));
}

QMessageBox::StandardButton Messages::ask(QMessageBox::Icon icon, const QString &question,
                                          QMessageBox::StandardButtons answers,
                                          QMessageBox::StandardButton usual) const {
  QMessageBox box(icon, tr("Halfspace"), question, answers, m_window);
  box.setTextFormat(Qt::PlainText); // it may quote a stranger's file
  if (usual != QMessageBox::NoButton)
    box.setDefaultButton(usual);
  return static_cast<QMessageBox::StandardButton>(box.exec());
}

} // namespace halfspace
