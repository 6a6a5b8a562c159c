#include "app/explore/answer_fields.h"

#include "lessons/lesson/lesson.h"

#include <QFormLayout>
#include <QLineEdit>

namespace halfspace {

AnswerFields::AnswerFields(const std::vector<std::string> &words, const std::string &now,
                           const AnswerTexts &texts) {
  auto *form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const std::string &word, const QString &title) {
    auto *field = new QLineEdit;
    field->setObjectName("answer-" + QString::fromStdString(word));
    field->setPlaceholderText(tr("Not among the answers"));
    if (const auto text = texts.find(word); text != texts.end())
      field->setText(text->second);
    form->addRow(title, field);
    connect(field, &QLineEdit::textChanged, this, &AnswerFields::changed);
    m_fields.emplace_back(word, field);
  };
  for (const std::string &word : words) {
    const QString read = QString::fromStdString(word).replace('-', ' ');
    add(word, word == now ? tr("%1 (as it is now):").arg(read) : tr("%1:").arg(read));
  }
  add(otherwise, tr("anything else:"));
}

std::vector<DraftChoice> AnswerFields::choices() const {
  std::vector<DraftChoice> choices;
  for (const auto &[word, field] : m_fields)
    if (!field->text().trimmed().isEmpty())
      choices.push_back({word, field->text().toStdString()});
  return choices;
}

AnswerTexts AnswerFields::texts() const {
  AnswerTexts texts;
  for (const auto &[word, field] : m_fields)
    texts[word] = field->text();
  return texts;
}

} // namespace halfspace
