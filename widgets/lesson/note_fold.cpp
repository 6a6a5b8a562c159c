#include "widgets/lesson/note_fold.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace halfspace {
namespace {

/// The text in lines that are as full as the room allows: a button breaks none by itself.
QString broken(const QString &text, const QFontMetrics &metrics, int room) {
  QString lines;
  QString line;
  for (const QString &word : text.split(' ')) {
    const QString longer = line.isEmpty() ? word : line + ' ' + word;
    if (line.isEmpty() || metrics.horizontalAdvance(longer) <= room) {
      line = longer;
      continue;
    }
    lines += line + '\n';
    line = word;
  }
  return lines + line;
}

} // namespace

NoteFold::NoteFold(const Typesetter &typesetter, const QString &title, QWidget *parent)
    : QWidget(parent), m_text(QString(title).replace('&', QLatin1String("&&"))), // no key of it
      m_title(new QToolButton), m_words(new RichLabel(typesetter)) {
  m_title->setText(m_text);
  m_title->setAccessibleName(title);
  m_title->setMinimumWidth(1); // it is broken where there is no room
  m_title->setObjectName("note");
  m_title->setCheckable(true);
  m_title->setAutoRaise(true);
  m_title->setArrowType(Qt::RightArrow);
  m_title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_title->setFocusPolicy(Qt::StrongFocus);
  m_words->hide();
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_title, 0, Qt::AlignLeft);
  layout->addWidget(m_words);
  connect(m_title, &QToolButton::toggled, this, [this](bool open) {
    m_title->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    m_words->setVisible(open);
    if (open)
      emit opened();
  });
}

void NoteFold::resizeEvent(QResizeEvent *event) {
  QWidget::resizeEvent(event);
  const QFontMetrics metrics = m_title->fontMetrics();
  m_title->setText(m_text);
  const int besideText = m_title->sizeHint().width() - metrics.horizontalAdvance(m_text);
  m_title->setText(broken(m_text, metrics, width() - besideText));
}

bool NoteFold::isOpen() const { return m_title->isChecked(); }

void NoteFold::setTheme(const Theme &theme) { m_words->setInk(theme.mutedInk, theme); }

} // namespace halfspace
