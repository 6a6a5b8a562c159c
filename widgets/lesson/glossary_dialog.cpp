#include "widgets/lesson/glossary_dialog.h"

#include "widgets/lesson/name_list.h"
#include "widgets/text/rich_label.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <optional>
#include <utility>

namespace halfspace {
namespace {

/// The usual width of the whole, and that of a figure, in letters.
constexpr int lettersInAll = 90;
constexpr int lettersBeside = 56;
/// The height of the whole, in lines.
constexpr int usualLines = 26;
/// Of a figure, in its width.
constexpr double figureHeight = 0.6;
/// The size of the term above its meaning, in that of other words.
constexpr double largeWords = 1.3;

/// How well words name an entry, from 0, the best; nothing where they do not.
std::optional<int> rankOf(const GlossaryDialog::Entry &entry, const QString &words) {
  if (entry.term.compare(words, Qt::CaseInsensitive) == 0)
    return 0;
  if (entry.also.split(", ").contains(words, Qt::CaseInsensitive))
    return 1;
  if (entry.term.startsWith(words, Qt::CaseInsensitive))
    return 2;
  const bool isSomewhere =
      entry.term.contains(words, Qt::CaseInsensitive) || entry.also.contains(words, Qt::CaseInsensitive);
  return isSomewhere ? std::optional(3) : std::nullopt;
}

} // namespace

GlossaryDialog::GlossaryDialog(const Typesetter &typesetter, QWidget *parent)
    : QDialog(parent), m_search(new QLineEdit), m_list(new NameList), m_term(new QLabel),
      m_meaning(new RichLabel(typesetter)), m_picture(new QLabel), m_lesson(new QPushButton) {
  setObjectName("glossary");
  setWindowTitle(tr("Glossary"));
  m_search->setObjectName("termSearch");
  m_search->setPlaceholderText(tr("Search"));
  m_search->setAccessibleName(tr("Search the terms"));
  m_search->setClearButtonEnabled(true);
  m_list->setObjectName("terms");
  m_list->setAccessibleName(tr("Terms"));
  QFont large = m_term->font();
  large.setPointSizeF(large.pointSizeF() * largeWords);
  large.setBold(true);
  m_term->setFont(large);
  m_term->setTextFormat(Qt::PlainText);
  m_term->setWordWrap(true);
  m_picture->setObjectName("termFigure");
  m_lesson->setObjectName("termLesson");
  m_lesson->setAutoDefault(false); // Enter in the search is not meant for it
  const int letter = fontMetrics().averageCharWidth();
  auto *terms = new QVBoxLayout;
  terms->addWidget(m_search);
  terms->addWidget(m_list, 1);
  auto *details = new QVBoxLayout;
  details->addWidget(m_term);
  details->addWidget(m_meaning);
  details->addWidget(m_picture);
  details->addStretch(1);
  details->addWidget(m_lesson, 0, Qt::AlignLeft);
  auto *columns = new QHBoxLayout(this);
  columns->addLayout(terms);
  columns->addLayout(details, 1);
  connect(m_search, &QLineEdit::textChanged, this, &GlossaryDialog::search);
  connect(m_list, &NameList::currentRowChanged, this, &GlossaryDialog::showChosen);
  connect(m_lesson, &QPushButton::clicked, this,
          [this] { emit lessonWanted(static_cast<std::size_t>(m_list->currentRow())); });
  resize(lettersInAll * letter, usualLines * fontMetrics().lineSpacing());
}

void GlossaryDialog::setEntries(std::vector<Entry> entries, Figure figure) {
  m_entries = std::move(entries);
  m_figure = std::move(figure);
  QStringList terms;
  for (const Entry &entry : m_entries)
    terms << entry.term;
  m_list->setNames(terms);
  search(m_search->text());
  showChosen();
}

void GlossaryDialog::setTheme(const Theme &theme) { m_meaning->setInk(theme.ink, theme); }

void GlossaryDialog::open(const QString &term) {
  if (m_list->choose(term))
    m_search->clear(); // else it may be hidden
  show();
  raise();
  activateWindow();
  m_search->setFocus();
}

void GlossaryDialog::search(const QString &words) {
  int best = -1;
  std::optional<int> bestRank;
  for (int row = 0; row < m_list->count(); ++row) {
    const auto rank = rankOf(m_entries[static_cast<std::size_t>(row)], words.trimmed());
    m_list->item(row)->setHidden(!rank);
    if (rank && (!bestRank || *rank < *bestRank)) {
      best = row;
      bestRank = rank;
    }
  }
  const QListWidgetItem *chosen = m_list->currentItem();
  const bool isNamed = !words.trimmed().isEmpty();
  if (isNamed || !chosen || chosen->isHidden())
    m_list->setCurrentRow(best);
}

void GlossaryDialog::showChosen() {
  const int row = m_list->currentRow();
  m_lesson->setEnabled(row >= 0);
  m_lesson->setVisible(row >= 0);
  if (row < 0) {
    m_term->setText(tr("There is no such term."));
    m_meaning->setWords({});
    m_picture->clear();
    return;
  }
  const auto place = static_cast<std::size_t>(row);
  const Entry &entry = m_entries[place];
  m_term->setText(entry.term);
  m_meaning->setWords(withNames(entry.meaning.markdown()));
  m_lesson->setText(tr("Open “%1”", "a lesson").arg(entry.lesson));
  const int width = lettersBeside * fontMetrics().averageCharWidth();
  m_picture->setPixmap(m_figure(place, {width, static_cast<int>(width * figureHeight)}));
}

} // namespace halfspace
