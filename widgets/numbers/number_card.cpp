#include "widgets/numbers/number_card.h"

#include "widgets/flow_layout.h"
#include "widgets/numbers/number_field.h"
#include "widgets/repolish.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>

#include <algorithm>

namespace halfspace {
namespace {

/// An object with more coordinates than this shows the selected one alone.
constexpr std::size_t mostCoordinates = 3;
/// A field is so wide, in letters: −10/3 and its margins.
constexpr int lettersInField = 9;
/// The usual card is so wide, likewise.
constexpr int usualLetters = 56;
/// A field with its frame, in heights of its type.
constexpr double fieldHeight = 1.7;
// In pixels.
constexpr QMargins cardMargins(10, 7, 10, 6);
constexpr int groupGap = 12;
constexpr int rowGap = 4;

QLabel *wordsLabel(const char *name) {
  auto *label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  return label;
}

/// A letter and its fields beside each other.
QWidget *groupOf(const CoordinateRow &row) {
  auto *group = new QWidget;
  auto *layout = new QHBoxLayout(group);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(rowGap);
  layout->addWidget(row.letter());
  for (NumberField *field : row.fields()) {
    field->setFixedWidth(lettersInField * field->fontMetrics().averageCharWidth());
    layout->addWidget(field);
  }
  return group;
}

} // namespace

NumberCard::NumberCard(SessionModel &model, const Typesetter &typesetter, QWidget *parent)
    : QFrame(parent), m_model(model), m_given(model, typesetter), m_theme(themes().front()),
      m_numbers(new QWidget), m_complaint(wordsLabel("complaint")), m_hintLabel(wordsLabel("hint")) {
  setObjectName("card");
  m_hintLabel->setMinimumWidth(1); // it is cut short where there is no room
  m_complaint->setWordWrap(true);
  m_complaint->hide();
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(cardMargins);
  layout->setSpacing(rowGap);
  for (QWidget *widget :
       {m_numbers, static_cast<QWidget *>(m_complaint), static_cast<QWidget *>(m_hintLabel)})
    layout->addWidget(widget);
  connect(&m_given, &CoordinateRows::refused, this, [this](const QString &sentence) {
    m_complaint->setText(sentence);
    m_complaint->setVisible(!sentence.isEmpty());
  });
  connect(&model, &SessionModel::outcomeChanged, this, &NumberCard::showSession);
  setAccessibleName(tr("Numbers of the selected object"));
  setSelection({});
}

NumberCard::~NumberCard() = default;

void NumberCard::setSelection(const std::optional<CoordinateId> &selected) {
  m_selected = selected;
  m_hintRoom = m_hintLabel->fontMetrics().horizontalAdvance(m_hint);
  showSession();
}

std::vector<CoordinateId> NumberCard::shownCoordinates() const {
  const Scene &scene = m_model.session().scene;
  const Object *object = m_selected ? findObject(scene, m_selected->object) : nullptr;
  if (!object)
    return {};
  std::vector<CoordinateId> ids = coordinatesOf(scene, m_selected->object);
  if (ids.size() > mostCoordinates)
    std::erase_if(ids, [this](const CoordinateId &id) { return id.index != m_selected->index; });
  return ids;
}

void NumberCard::build(const std::vector<CoordinateId> &ids) {
  m_complaint->hide();
  auto *numbers = new QWidget;
  auto *flow = new FlowLayout(numbers);
  flow->setContentsMargins(0, 0, 0, 0);
  flow->setSpacing(groupGap);
  for (const auto &row : m_given.make(ids))
    flow->addWidget(groupOf(*row));
  m_given.setTheme(m_theme);
  delete layout()->replaceWidget(m_numbers, numbers);
  numbers->setVisible(!ids.empty()); // only now: without a parent it would be a window
  m_numbers->hide();
  m_numbers->deleteLater(); // a number that was typed in it may have led here
  m_numbers = numbers;
  setProperty("framed", !ids.empty());
  repolish(*this);
}

void NumberCard::showSession() {
  const std::vector<CoordinateId> ids = shownCoordinates();
  if (!m_given.areMadeFor(ids))
    build(ids);
  m_given.showNumbers();
}

void NumberCard::setHint(const QString &words) {
  if (words == m_hint)
    return;
  m_hint = words;
  const int needed = m_hintLabel->fontMetrics().horizontalAdvance(m_hint);
  m_hintRoom = m_selected ? std::max(m_hintRoom, needed) : needed;
  showHint();
}

void NumberCard::showHint() {
  m_hintLabel->setVisible(!m_hint.isEmpty());
  elideHint();
  updateGeometry();
}

void NumberCard::elideHint() {
  const QFontMetrics type = m_hintLabel->fontMetrics();
  const int room = width() - cardMargins.left() - cardMargins.right();
  const QString sentenceEnd = QStringLiteral(". ");
  QString shown = m_hint;
  // As many whole sentences as there is room for, and the first in any case.
  while (type.horizontalAdvance(shown) > room && shown.contains(sentenceEnd))
    shown = shown.left(shown.lastIndexOf(sentenceEnd) + 1);
  m_hintLabel->setText(type.elidedText(shown, Qt::ElideRight, room));
}

QSize NumberCard::sizeHint() const {
  const QSize whole(m_hintRoom + 2 * frameWidth() + cardMargins.left() + cardMargins.right(), 0);
  return QFrame::sizeHint().expandedTo(whole);
}

void NumberCard::resizeEvent(QResizeEvent *event) {
  QFrame::resizeEvent(event);
  elideHint();
}

QSize NumberCard::usualSize() const {
  const QFontMetrics type = fontMetrics();
  const int lines = qRound((fieldHeight + 1) * type.height());
  return {usualLetters * type.averageCharWidth(), cardMargins.top() + lines + rowGap + cardMargins.bottom()};
}

void NumberCard::setTheme(const Theme &theme) {
  m_theme = theme;
  build(shownCoordinates()); // the fields' widths follow the type
  showSession();
}

} // namespace halfspace
