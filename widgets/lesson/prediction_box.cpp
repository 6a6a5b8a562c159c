#include "widgets/lesson/prediction_box.h"

#include "widgets/colors.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace halfspace {

namespace {

/// Around the words at a text scale of 1, with room for the verdict.
constexpr QMargins choiceMargins(34, 7, 12, 7);
constexpr double markRadius = 7;
constexpr double cornerRadius = 6;

/// Words with others before them: in their first paragraph, unless that is a formula alone.
FilledMarkdown withBefore(const std::vector<MarkdownSpan> &before, FilledMarkdown words) {
  if (before.empty())
    return words;
  const auto isText = [](const MarkdownBlock &block) {
    return block.kind == MarkdownBlock::Kind::Paragraph &&
           !(block.spans.size() == 1 && block.spans.front().kind == MarkdownSpan::Kind::Formula);
  };
  if (words.blocks.empty() || !isText(words.blocks.front()))
    words.blocks.insert(words.blocks.begin(), MarkdownBlock());
  std::vector<MarkdownSpan> &spans = words.blocks.front().spans;
  spans.insert(spans.begin(), before.begin(), before.end());
  return words;
}

MarkdownSpan spanOf(const QString &words, bool strong) {
  MarkdownSpan span;
  span.text = words.toStdString() + ' ';
  span.face.strong = strong;
  return span;
}

} // namespace

ChoiceButton::ChoiceButton(const Typesetter &typesetter, const MarkdownText &words, QWidget *parent)
    : QAbstractButton(parent), m_label(new RichLabel(typesetter)), m_theme(themes().front()) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(choiceMargins);
  layout->addWidget(m_label);
  m_label->setWords(withNames(words.markdown()));
  m_label->setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(m_label->plain());
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setCursor(Qt::PointingHandCursor);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void ChoiceButton::setVerdict(Verdict verdict, bool isOfNow) {
  m_verdict = verdict;
  m_isOfNow = isOfNow;
  const QString word = verdict == Verdict::Open    ? QString()
                       : verdict == Verdict::Right ? tr("Right")
                                                   : tr("Wrong");
  setAccessibleDescription(isOfNow || word.isEmpty() ? word : tr("%1 before the change").arg(word));
  showInk();
}

void ChoiceButton::setTheme(const Theme &theme) {
  m_theme = theme;
  layout()->setContentsMargins(choiceMargins * theme.textScale);
  showInk();
}

void ChoiceButton::showInk() {
  m_label->setInk(m_isOfNow ? m_theme.ink : m_theme.mutedInk, m_theme);
  update();
}

bool ChoiceButton::event(QEvent *event) {
  if (event->type() != QEvent::ToolTip)
    return QAbstractButton::event(event);
  const auto *help = static_cast<QHelpEvent *>(event); // the label gets none: the pointer is on the button
  QHelpEvent forLabel(QEvent::ToolTip, m_label->mapFromParent(help->pos()), help->globalPos());
  return QCoreApplication::sendEvent(m_label, &forLabel);
}

Color ChoiceButton::edge() const {
  if (!m_isOfNow)
    return m_theme.border;
  return m_verdict == Verdict::Right                               ? m_theme.inkOf(Subject::Triangle)
         : m_verdict == Verdict::Wrong                             ? m_theme.warning
         : hasFocus() || isDown() || (isEnabled() && underMouse()) ? m_theme.accent
                                                                   : m_theme.border;
}

void ChoiceButton::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Color edge = this->edge();
  const double tint = m_verdict != Verdict::Open    ? 0.10
                      : isDown()                    ? 0.14
                      : isEnabled() && underMouse() ? 0.07
                                                    : 0;
  painter.setPen(QPen(toQColor(edge), hasFocus() ? 2 : 1.2));
  painter.setBrush(toQColor(mix(m_theme.panel, edge, tint)));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), cornerRadius, cornerRadius);
  paintVerdict(painter, {layout()->contentsMargins().left() / 2.0, height() / 2.0},
               markRadius * m_theme.textScale, m_verdict, m_theme, m_isOfNow);
}

PredictionBox::PredictionBox(const Typesetter &typesetter, const Prediction &prediction, QWidget *parent)
    : QWidget(parent), m_prediction(prediction), m_question(new RichLabel(typesetter)),
      m_reason(new RichLabel(typesetter)), m_again(new QToolButton), m_theme(themes().front()) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(7);
  m_question->setWords(withNames(prediction.question.markdown()));
  layout->addWidget(m_question);
  for (const Prediction::Choice &choice : prediction.choices) {
    auto *button = new ChoiceButton(typesetter, choice.text);
    connect(button, &QAbstractButton::clicked, this,
            [this, word = QString::fromStdString(choice.word)] { emit chosen(word); });
    m_buttons << button;
    layout->addWidget(button);
  }
  layout->addWidget(m_reason);
  m_again->setText(tr("Try again"));
  m_again->setObjectName("again");
  m_again->setToolTip(tr("Hide the numbers and answer once more, as with other numbers."));
  m_again->setAutoRaise(true);
  m_again->setFocusPolicy(Qt::StrongFocus);
  layout->addWidget(m_again, 0, Qt::AlignLeft);
  connect(m_again, &QToolButton::clicked, this, &PredictionBox::reopened);
  m_reason->hide();
  m_again->hide();
}

void PredictionBox::setAnswer(const std::optional<GivenAnswer> &answer) {
  m_isOfNow = !answer || answer->isOfNow;
  for (int i = 0; i < m_buttons.size(); ++i) {
    const std::string &word = m_prediction.choices[static_cast<std::size_t>(i)].word;
    m_buttons[i]->setEnabled(!answer);
    m_buttons[i]->setVerdict(!answer || answer->right.empty() ? Verdict::Open
                             : word == answer->right          ? Verdict::Right
                             : word == answer->chosen         ? Verdict::Wrong
                                                              : Verdict::Open,
                             m_isOfNow);
  }
  m_reason->setVisible(answer.has_value());
  // Where the right answer stands there is nothing left to try, unless it was about another scene.
  m_again->setVisible(answer && (!m_isOfNow || answer->right.empty()));
  if (answer)
    showReason(*answer);
  showInk();
}

void PredictionBox::showReason(const GivenAnswer &answer) {
  std::vector<MarkdownSpan> before;
  if (!answer.right.empty())
    before.push_back(spanOf(answer.chosen == answer.right ? tr("Right.") : tr("Not quite."), true));
  if (!answer.isOfNow)
    before.push_back(spanOf(tr("That was about the scene before it was changed."), false));
  m_reason->setWords(withBefore(before, withNames(m_prediction.reason.markdown())));
}

void PredictionBox::setTheme(const Theme &theme) {
  m_theme = theme;
  m_question->setInk(theme.ink, theme);
  for (ChoiceButton *button : m_buttons)
    button->setTheme(theme);
  showInk();
}

void PredictionBox::showInk() { m_reason->setInk(m_isOfNow ? m_theme.ink : m_theme.mutedInk, m_theme); }

} // namespace halfspace
