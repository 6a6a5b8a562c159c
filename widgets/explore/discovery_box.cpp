#include "widgets/explore/discovery_box.h"

#include "lessons/discovery/discover.h"
#include "widgets/scene_selection.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace halfspace {

DiscoveryBox::DiscoveryBox(const SessionModel &model, const SceneSelection &selection, QWidget *parent)
    : QWidget(parent), m_model(model), m_selection(selection),
      m_button(new QPushButton(tr("What holds of them?"))), m_answer(new QLabel) {
  m_button->setObjectName("discover");
  m_button->setToolTip(
      tr("Whether they are parallel, perpendicular, in one plane, equally long … and whether "
         "that is always so."));
  m_answer->setObjectName("discoveries");
  m_answer->setTextFormat(Qt::PlainText);
  m_answer->setWordWrap(true);
  m_answer->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_button, 0, Qt::AlignLeft);
  column->addWidget(m_answer);
  connect(m_button, &QPushButton::clicked, this, &DiscoveryBox::discover);
  connect(&selection, &SceneSelection::changed, this, &DiscoveryBox::forget);
  connect(&model, &SessionModel::outcomeChanged, this, &DiscoveryBox::forget);
  forget();
}

void DiscoveryBox::forget() {
  m_button->setVisible(m_selection.ids().size() > 1);
  m_answer->hide();
}

void DiscoveryBox::discover() {
  QStringList sentences;
  if (m_selection.ids().size() > mostLookedAt)
    sentences << tr("Only the first %1 are looked at.").arg(mostLookedAt);
  const std::vector<Discovery> discoveries = discoveriesOf(m_model.evaluation(), m_selection.ids());
  for (const Discovery &discovery : discoveries)
    sentences << "• " + QString::fromStdString(wordsFor(discovery));
  if (discoveries.empty())
    sentences << tr("Nothing special holds of them.");
  m_answer->setText(sentences.join('\n'));
  m_answer->show();
}

} // namespace halfspace
