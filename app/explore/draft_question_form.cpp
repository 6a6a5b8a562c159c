#include "app/explore/draft_question_form.h"

#include "app/explore/short_text.h"
#include "lessons/lesson/condition.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QScrollArea>

#include <algorithm>

namespace halfspace {
namespace {

constexpr int linesOfWhy = 2;

std::vector<OfferedValue> wordsAmong(std::vector<OfferedValue> values) {
  std::erase_if(values, [](const OfferedValue &each) { return each.value.shape != ValueShape::Word; });
  return values;
}

/// The word that a value is; empty for none.
std::string wordOf(const Evaluation &evaluation, const std::string &name) {
  const auto value = findValue(evaluation, name);
  const auto *word = value ? std::get_if<Word>(&*value) : nullptr;
  return word ? word->name : std::string();
}

} // namespace

DraftQuestionForm::DraftQuestionForm(const Evaluation &start)
    : QGroupBox(tr("As&k something before the numbers are shown")), m_start(start),
      m_values(wordsAmong(comparableValues(start.scene))), m_ask(new QLineEdit), m_value(new QComboBox),
      m_room(new QScrollArea), m_why(shortText("why", linesOfWhy)) {
  setObjectName("question");
  setCheckable(true);
  setChecked(false);
  m_ask->setObjectName("ask");
  m_value->setObjectName("decides");
  for (const OfferedValue &each : m_values)
    m_value->addItem(QString::fromStdString(each.name));
  m_room->setWidgetResizable(true);
  m_room->setFrameShape(QFrame::NoFrame);
  m_room->setFocusPolicy(Qt::NoFocus); // its fields have it
  auto *form = new QFormLayout(this);
  form->addRow(tr("&Question:"), m_ask);
  form->addRow(tr("What &decides:"), m_value);
  form->addRow(tr("Answers:"), m_room);
  form->addRow(tr("W&hy it is so:"), m_why);
  if (m_values.empty()) {
    setEnabled(false);
    setToolTip(tr("Nothing in the scene has a word as its value, as the case of a construction is."));
  }
  connect(m_ask, &QLineEdit::textChanged, this, &DraftQuestionForm::changed);
  connect(m_why, &QPlainTextEdit::textChanged, this, &DraftQuestionForm::changed);
  connect(this, &QGroupBox::toggled, this, &DraftQuestionForm::changed);
  connect(m_value, qOverload<int>(&QComboBox::currentIndexChanged), this, &DraftQuestionForm::showAnswers);
  showAnswers();
}

void DraftQuestionForm::showAnswers() {
  if (m_values.empty())
    return;
  if (m_answers)
    for (const auto &[word, text] : m_answers->texts())
      m_texts[word] = text;
  const OfferedValue &value = m_values[static_cast<std::size_t>(std::max(0, m_value->currentIndex()))];
  m_answers = new AnswerFields(value.value.words, wordOf(m_start, value.name), m_texts);
  connect(m_answers, &AnswerFields::changed, this, &DraftQuestionForm::changed);
  m_room->setWidget(m_answers); // the one before goes
  emit changed();
}

void DraftQuestionForm::fill(const std::optional<DraftQuestion> &question) {
  const QSignalBlocker untold(this);
  const DraftQuestion filled = question.value_or(DraftQuestion());
  setChecked(question.has_value());
  m_ask->setText(QString::fromStdString(filled.ask));
  m_why->setPlainText(QString::fromStdString(filled.why));
  m_texts.clear();
  for (const DraftChoice &choice : filled.choices)
    m_texts[choice.word] = QString::fromStdString(choice.text);
  m_answers = nullptr; // what stands there is of another question
  const QSignalBlocker unheard(m_value);
  m_value->setCurrentIndex(std::max(0, m_value->findText(QString::fromStdString(filled.value))));
  showAnswers();
}

std::optional<DraftQuestion> DraftQuestionForm::question() const {
  if (!isEnabled() || !isChecked() || !m_answers)
    return {};
  return DraftQuestion{m_ask->text().toStdString(), m_value->currentText().toStdString(),
                       m_answers->choices(), m_why->toPlainText().toStdString()};
}

} // namespace halfspace
