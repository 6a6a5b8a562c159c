#include "app/explore/draft_step_list.h"

#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

namespace halfspace {
namespace {

QString numbered(int step, const QString &title) { return QStringLiteral("%1  %2").arg(step + 1).arg(title); }

QPushButton *button(const QString &words, const QString &name) {
  auto *button = new QPushButton(words);
  button->setObjectName(name);
  button->setAutoDefault(false); // Enter belongs to the fields
  return button;
}

} // namespace

DraftStepList::DraftStepList()
    : m_list(new QListWidget), m_remove(button(tr("&Remove"), "removeStep")),
      m_up(button(tr("&Up"), "stepUp")), m_down(button(tr("Do&wn"), "stepDown")) {
  m_list->setObjectName("draftSteps");
  QPushButton *add = button(tr("&Add"), "addStep");
  auto *words = new QLabel(tr("&Steps:"));
  words->setBuddy(m_list);
  auto *grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(words, 0, 0, 1, 2);
  grid->addWidget(m_list, 1, 0, 1, 2);
  grid->addWidget(add, 2, 0);
  grid->addWidget(m_remove, 2, 1);
  grid->addWidget(m_up, 3, 0);
  grid->addWidget(m_down, 3, 1);
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
    enable();
    emit chosen(row);
  });
  connect(add, &QPushButton::clicked, this, &DraftStepList::addWanted);
  connect(m_remove, &QPushButton::clicked, this, &DraftStepList::removeWanted);
  connect(m_up, &QPushButton::clicked, this, [this] { emit moveWanted(-1); });
  connect(m_down, &QPushButton::clicked, this, [this] { emit moveWanted(1); });
}

void DraftStepList::show(const QStringList &titles, int chosen) {
  const QSignalBlocker untold(m_list);
  m_list->clear();
  for (int step = 0; step < titles.size(); ++step)
    m_list->addItem(numbered(step, titles[step]));
  m_list->setCurrentRow(chosen);
  enable();
}

void DraftStepList::setTitle(int step, const QString &title) {
  m_list->item(step)->setText(numbered(step, title));
}

void DraftStepList::enable() {
  const int row = m_list->currentRow();
  m_remove->setEnabled(m_list->count() > 1);
  m_up->setEnabled(row > 0);
  m_down->setEnabled(row + 1 < m_list->count());
}

} // namespace halfspace
