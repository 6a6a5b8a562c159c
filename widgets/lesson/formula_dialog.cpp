#include "widgets/lesson/formula_dialog.h"

#include "widgets/text/rich_label.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// The usual width of the whole, in letters.
constexpr int lettersInAll = 100;
/// The height of the whole, in lines.
constexpr int usualLines = 34;
/// Above and below a chapter of the list, in pixels.
constexpr int rowGap = 1;
/// Between the formulas of one lesson and the title of the next, in lines.
constexpr double linesBetweenLessons = 0.8;

/// What stands for a chapter without a name.
QString nameOf(const ChapterFormulas &chapter) {
  return chapter.chapter.empty() ? FormulaDialog::tr("Other lessons")
                                 : QString::fromStdString(chapter.chapter);
}

} // namespace

FormulaDialog::FormulaDialog(const Typesetter &typesetter, QWidget *parent)
    : QDialog(parent), m_typesetter(typesetter), m_list(new QListWidget), m_page(new QScrollArea),
      m_theme(themes().front()) {
  setObjectName("formulas");
  setWindowTitle(tr("Formulas"));
  m_list->setObjectName("chapters");
  m_list->setAccessibleName(tr("Chapters"));
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setSpacing(rowGap);
  m_page->setWidgetResizable(true);
  m_page->setFrameShape(QFrame::NoFrame);
  auto *columns = new QHBoxLayout(this);
  columns->addWidget(m_list);
  columns->addWidget(m_page, 1);
  connect(m_list, &QListWidget::currentRowChanged, this, &FormulaDialog::showChosen);
  resize(lettersInAll * fontMetrics().averageCharWidth(), usualLines * fontMetrics().lineSpacing());
}

void FormulaDialog::setChapters(std::vector<ChapterFormulas> chapters) {
  const QString chosen = m_list->currentItem() ? m_list->currentItem()->text() : QString();
  const QSignalBlocker untilChosen(m_list);
  m_list->clear();
  m_chapters = std::move(chapters);
  int widest = 0;
  for (const ChapterFormulas &chapter : m_chapters) {
    m_list->addItem(nameOf(chapter));
    widest = std::max(widest, m_list->fontMetrics().horizontalAdvance(nameOf(chapter)));
  }
  const int letter = m_list->fontMetrics().averageCharWidth();
  const int edges = 2 * (m_list->frameWidth() + letter) + m_list->verticalScrollBar()->sizeHint().width();
  m_list->setFixedWidth(widest + edges); // each name is seen whole
  m_list->setCurrentRow(0);
  choose(chosen);
  showChosen();
}

void FormulaDialog::setTheme(const Theme &theme) { m_theme = theme; }

void FormulaDialog::open(const QString &chapter) {
  choose(chapter);
  show();
  raise();
  activateWindow();
  m_list->setFocus();
}

void FormulaDialog::choose(const QString &chapter) {
  const auto found = m_list->findItems(chapter, Qt::MatchExactly);
  if (!found.isEmpty())
    m_list->setCurrentItem(found.front());
}

void FormulaDialog::showChosen() {
  const int row = m_list->currentRow();
  m_page->setWidget(row < 0 ? new QWidget : pageOf(m_chapters.at(static_cast<std::size_t>(row))));
}

QWidget *FormulaDialog::pageOf(const ChapterFormulas &chapter) {
  auto *page = new QWidget;
  auto *column = new QVBoxLayout(page);
  for (const LessonFormulas &lesson : chapter.lessons) {
    auto *title = new QToolButton;
    title->setObjectName("formulaLesson");
    title->setText(QString::fromStdString(lesson.title).replace('&', QLatin1String("&&")));
    title->setToolTip(tr("Open this lesson."));
    title->setAutoRaise(true);
    title->setCursor(Qt::PointingHandCursor);
    title->setFocusPolicy(Qt::StrongFocus);
    QFont strong = title->font();
    strong.setBold(true);
    title->setFont(strong);
    connect(title, &QToolButton::clicked, this,
            [this, id = QString::fromStdString(lesson.lesson)] { emit lessonWanted(id); });
    column->addWidget(title, 0, Qt::AlignLeft);
    for (const MarkdownText &formulas : lesson.formulas) {
      auto *words = new RichLabel(m_typesetter);
      words->setInk(m_theme.ink, m_theme);
      words->setWords(withNames(formulas.markdown()));
      column->addWidget(words);
    }
    column->addSpacing(static_cast<int>(linesBetweenLessons * fontMetrics().lineSpacing()));
  }
  column->addStretch(1);
  return page;
}

} // namespace halfspace
