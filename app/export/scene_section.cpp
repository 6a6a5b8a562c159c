#include "app/export/scene_section.h"

#include "widgets/carriers/carrier.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>

namespace halfspace {
SceneSection::SceneSection()
    : ExportSection(tr("Scene")), m_carriesSession(new QCheckBox(tr("File can be &opened again"))),
      m_code(new QCheckBox(tr("&QR code beside the figure"))), m_note(new QLabel) {
  m_carriesSession->setObjectName("session");
  m_code->setObjectName("code");
  m_code->setToolTip(tr("A photograph of the printed figure can be opened again."));
  m_note->setObjectName("sessionNote");
  m_note->setWordWrap(true);
  form().addRow(m_carriesSession);
  form().addRow(m_note);
  form().addRow(m_code);
  for (const QCheckBox *box : {m_carriesSession, m_code})
    connect(box, &QCheckBox::toggled, this, &SceneSection::changed);
}

void SceneSection::fill(const ExportChoices &choices) {
  m_carriesSession->setChecked(choices.carriesSession);
  m_code->setChecked(choices.hasCode);
}

void SceneSection::enableFor(const ExportChoices &choices) {
  const Carrier *carrier = carrierWith(choices.ending);
  m_carriesSession->setEnabled(carrier);
  m_code->setEnabled(choices.mayTellScene()); // without a scene there is nothing to write into it
  m_note->setText(!carrier ? tr("A file of this format carries no scene.")
                  : choices.carriesSession
                      ? QString::fromStdString(carrier->lostBy())
                      : tr("The file shows the figure, and does not tell how to make it."));
  m_carriesSession->setAccessibleDescription(m_note->text());
}

void SceneSection::put(ExportChoices &choices) const {
  choices.carriesSession = m_carriesSession->isChecked();
  choices.hasCode = m_code->isChecked();
}

} // namespace halfspace
