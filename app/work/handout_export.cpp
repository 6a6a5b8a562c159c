#include "app/work/handout_export.h"

#include "app/work/handout_dialog.h"
#include "app/work/save_dialog.h"
#include "lessons/files/write_file.h"
#include "widgets/session_model.h"
#include "widgets/typeset/typesetter.h"

#include <QLocale>

namespace halfspace {

HandoutExport::HandoutExport(const SessionModel &model, const Typesetter &typesetter, Messages messages,
                             QObject *parent)
    : QObject(parent), m_model(model), m_typesetter(typesetter), m_messages(messages) {
  if (QLocale::system().measurementSystem() == QLocale::ImperialUSSystem)
    m_choices.paper = HandoutPaper::Letter;
}

void HandoutExport::askAndSave() {
  HandoutDialog dialog(m_model.lesson(), m_model.session().step, m_choices, &m_messages.window());
  if (dialog.exec() != QDialog::Accepted)
    return;
  m_choices = dialog.choices();
  const QString file = askWhereToSave(m_messages.window(), tr("Save handout"), tr("PDF documents (*.pdf)"),
                                      QString::fromStdString(m_model.session().lesson), "pdf");
  if (!file.isEmpty())
    saveTo(file, m_choices);
}

bool HandoutExport::saveTo(const QString &file, const HandoutChoices &choices) {
  const std::string content = handoutFile(m_model.lesson(), m_model.session(), choices, m_typesetter);
  if (const auto problem = writeFile(file.toStdString(), content)) {
    m_messages.complain(QString::fromStdString(problem->text()));
    return false;
  }
  m_messages.say(tr("Handout saved."));
  return true;
}

} // namespace halfspace
