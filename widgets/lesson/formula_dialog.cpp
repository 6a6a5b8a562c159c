#include "widgets/lesson/formula_dialog.h"

#include "widgets/lesson/name_list.h"
#include "widgets/text/rich_label.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QToolButton>

#include <utility>

namespace halfspace {
namespace {

/// The usual width of the whole, in letters.
constexpr int lettersInAll = 100;
/// The height of the whole, in lines.
constexpr int usualLines = 34;
/// Between the formulas of one lesson and the title of the next, in lines.
constexpr double linesBetweenLessons = 0.8;

} // namespace

FormulaDialog::FormulaDialog(const Typesetter &typesetter, QWidget *parent)
    : QDialog(parent), m_typesetter(typesetter), m_list(new NameList), m_room(new QScrollArea),
      m_page(*m_room, [this] { showChosen(); }), m_theme(themes().front()) {
  setObjectName("formulas");
  setWindowTitle(tr("Formulas"));
  m_list->setObjectName("chapters");
  m_list->setAccessibleName(tr("Chapters"));
  m_room->setWidgetResizable(true);
  m_room->setFrameShape(QFrame::NoFrame);
  auto *columns = new QHBoxLayout(this);
  columns->addWidget(m_list);
  columns->addWidget(m_room, 1);
  connect(m_list, &NameList::currentRowChanged, this, [this] { m_page.renew(); });
  resize(lettersInAll * fontMetrics().averageCharWidth(), usualLines * fontMetrics().lineSpacing());
}

void FormulaDialog::setChapters(std::vector<ChapterFormulas> chapters) {
  if (chapters == m_chapters)
    return;
  m_chapters = std::move(chapters);
  QStringList names;
  for (const ChapterFormulas &chapter : m_chapters)
    names << QString::fromStdString(chapter.chapter);
  m_list->setNames(names);
  m_page.renew();
}

void FormulaDialog::setTheme(const Theme &theme) {
  m_theme = theme;
  m_page.renew();
}

void FormulaDialog::open(const QString &chapter) {
  m_list->choose(chapter);
  show();
  raise();
  activateWindow();
  m_list->setFocus();
}

void FormulaDialog::showChosen() {
  if (QWidget *before = m_room->takeWidget())
    before->deleteLater(); // a click on one of its lessons may have led here
  const int row = m_list->currentRow();
  m_room->setWidget(row < 0 ? new QWidget : pageOf(m_chapters.at(static_cast<std::size_t>(row))));
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
