#include "app/work/handout_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

namespace halfspace {
namespace {

/// So many steps are seen at once, of this width in letters.
constexpr int shownSteps = 10;
constexpr int letters = 44;

} // namespace

HandoutDialog::HandoutDialog(const Lesson &lesson, int step, const HandoutChoices &choices, QWidget *parent)
    : QDialog(parent), m_before(choices), m_steps(new QListWidget), m_paper(new QComboBox),
      m_columns(new QComboBox), m_answers(new QCheckBox(tr("Print the &answers, too"))) {
  setWindowTitle(tr("Save handout"));
  setObjectName("handout");
  m_steps->setObjectName("steps");
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    auto *item =
        new QListWidgetItem(QStringLiteral("%1  %2").arg(i + 1).arg(lesson.steps[i].title.c_str()), m_steps);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  }
  m_steps->setMinimumSize(letters * fontMetrics().averageCharWidth(),
                          shownSteps * fontMetrics().lineSpacing());
  m_paper->setObjectName("paper");
  m_paper->addItems({tr("A4"), tr("Letter")});
  m_paper->setCurrentIndex(choices.paper == HandoutPaper::Letter ? 1 : 0);
  m_columns->setObjectName("columns");
  m_columns->addItems({tr("One"), tr("Two")});
  m_columns->setCurrentIndex(choices.columns - 1);
  m_answers->setObjectName("answers");
  m_answers->setChecked(choices.hasAnswers);

  auto *all = new QPushButton(tr("A&ll Steps"));
  auto *current = new QPushButton(tr("&This Step"));
  current->setObjectName("thisStep");
  connect(all, &QPushButton::clicked, this, [this] { choose({}); });
  connect(current, &QPushButton::clicked, this, [this, step] { choose(step); });
  auto *choosing = new QHBoxLayout;
  choosing->addWidget(all);
  choosing->addWidget(current);
  choosing->addStretch();

  auto *buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_steps, &QListWidget::itemChanged, this, [this, buttons] {
    buttons->button(QDialogButtonBox::Save)->setEnabled(!this->choices().steps.empty());
  });

  auto *form = new QFormLayout(this);
  auto *steps = new QLabel(tr("&Steps"));
  steps->setBuddy(m_steps);
  form->addRow(steps);
  form->addRow(m_steps);
  form->addRow(choosing);
  form->addRow(tr("&Paper"), m_paper);
  form->addRow(tr("&Columns"), m_columns);
  form->addRow(m_answers);
  form->addRow(buttons);
  choose({});
}

void HandoutDialog::choose(std::optional<int> only) {
  for (int i = 0; i < m_steps->count(); ++i)
    m_steps->item(i)->setCheckState(!only || i == *only ? Qt::Checked : Qt::Unchecked);
}

HandoutChoices HandoutDialog::choices() const {
  HandoutChoices choices = m_before;
  choices.steps.clear();
  for (int i = 0; i < m_steps->count(); ++i)
    if (m_steps->item(i)->checkState() == Qt::Checked)
      choices.steps.push_back(static_cast<std::size_t>(i));
  choices.paper = m_paper->currentIndex() == 1 ? HandoutPaper::Letter : HandoutPaper::A4;
  choices.columns = m_columns->currentIndex() + 1;
  choices.hasAnswers = m_answers->isChecked();
  return choices;
}

} // namespace halfspace
