#include "widgets/lesson/lesson_page.h"

#include "widgets/colors.h"
#include "widgets/working/working_practice.h"

#include <QApplication>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace halfspace {

namespace {

// In pixels, at the usual size of text.
constexpr int margin = 20;
constexpr int blockGap = 10;
constexpr QSize usualSize(430, 600);
/// A line of words has at most so many letters: longer ones are hard to follow.
constexpr int mostLettersInLine = 78;

/// Empty for a lesson of no file, and where the working folder that its path begins in is gone.
std::filesystem::path folderOf(const Lesson &lesson) {
  std::error_code error;
  return lesson.file.empty() ? std::filesystem::path()
                             : std::filesystem::absolute(lesson.file, error).parent_path();
}

} // namespace

LessonPage::LessonPage(const Typesetter &typesetter, WorkingPractice &practice, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_theme(themes().front()), m_practice(practice),
      m_scroll(new QScrollArea), m_page(new QVBoxLayout), m_head(new PageHead(practice)),
      m_blocks(new StepBlocks(m_typesetter, {}, {}, {}, practice.working(), m_flight)), m_foot(new PageFoot) {
  layOut();
  connect(m_foot, &PageFoot::stepRequested, this, &LessonPage::stepRequested);
  connect(m_foot, &PageFoot::nextLessonRequested, this, &LessonPage::nextLessonRequested);
  connect(m_scroll->verticalScrollBar(), &QScrollBar::rangeChanged, this, &LessonPage::setMargins);
  connect(&practice.working(), &StepWorking::reached, this, [this](WorkingBlock *block, const QRect &place) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // it may just have become higher
    const QRect there(block->mapTo(m_scroll->widget(), place.topLeft()), place.size());
    m_scroll->ensureVisible(there.center().x(), there.center().y(), 0, there.height() / 2);
  });
  setTheme(m_theme);
}

// The words look at the typesetter, and the plots at the job of m_flight.
LessonPage::~LessonPage() { delete m_scroll; }

void LessonPage::layOut() {
  setAutoFillBackground(true);
  auto *content = new QWidget;
  content->setLayout(m_page);
  m_page->addLayout(m_head);
  m_page->addWidget(m_blocks);
  m_page->addStretch(1);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setWidgetResizable(true);
  m_scroll->setWidget(content);
  m_scroll->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_scroll, 1);
  layout->addLayout(m_foot);
}

void LessonPage::setLesson(const Lesson &lesson) {
  m_folder = folderOf(lesson);
  m_typesetter = m_typesetter.with(lesson.macros);
  QStringList titles;
  for (const LessonStep &each : lesson.steps)
    titles << QString::fromStdString(each.title);
  m_foot->setSteps(titles);
  m_stepCount = static_cast<int>(titles.size());
}

void LessonPage::showStep(const LessonStep &step, int number, const Glossary &glossary) {
  m_head->setStep(number, m_stepCount, QString::fromStdString(step.title));
  // What is disabled or goes would hand its focus to a number field, and the next key would change the scene.
  if (isAncestorOf(QApplication::focusWidget()))
    setFocus();
  m_foot->setStep(number);
  makeBlocks(step, glossary);
  showTop();
}

void LessonPage::showTop() { m_scroll->verticalScrollBar()->setValue(0); }

void LessonPage::makeBlocks(const LessonStep &step, const Glossary &glossary) {
  auto *blocks = new StepBlocks(m_typesetter, step, glossary, {m_folder}, m_practice.working(), m_flight);
  connect(blocks, &StepBlocks::predictionChosen, this, [this](const QString &word) {
    // The choices are disabled now: the next widget that takes keys may be a number.
    if (!m_foot->focusNext())
      setFocus();
    emit predictionChosen(word);
  });
  connect(blocks, &StepBlocks::predictionReopened, this, &LessonPage::predictionReopened);
  connect(blocks, &StepBlocks::reached, this, [this](const QWidget *part) { scrollTo(*part); });
  delete m_page->replaceWidget(m_blocks, blocks);
  m_blocks->disconnect(this);
  m_blocks->hide();
  m_blocks->deleteLater(); // a click on one of its buttons may have led here
  m_blocks = blocks;
  setTheme(m_theme);
}

void LessonPage::scrollTo(const QWidget &part) {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // it gets its place
  const QRect place(part.mapTo(m_scroll->widget(), QPoint()), part.size());
  m_scroll->ensureVisible(0, place.bottom(), 0, margin);
  m_scroll->ensureVisible(0, place.top(), 0, 0); // of what is higher than the page the beginning
}

void LessonPage::setTheme(const Theme &theme) {
  m_theme = theme;
  QPalette background = palette();
  background.setColor(QPalette::Window, toQColor(theme.panel));
  setPalette(background);
  m_page->setSpacing(scaled(blockGap));
  m_head->setLook(theme, font());
  m_blocks->setGap(scaled(blockGap));
  m_blocks->setTheme(theme);
  m_foot->setTheme(theme);
  setMargins();
}

QSize LessonPage::sizeHint() const { return usualSize; }

int LessonPage::longestLine(const QFontMetrics &type) { return mostLettersInLine * type.averageCharWidth(); }

void LessonPage::resizeEvent(QResizeEvent *event) {
  setMargins();
  QWidget::resizeEvent(event);
}

int LessonPage::scaled(int pixels) const { return qRound(pixels * m_theme.textScale); }

void LessonPage::setMargins() {
  const QScrollBar &bar = *m_scroll->verticalScrollBar();
  const int besideLines = (width() - longestLine(fontMetrics())) / 2;
  const int side = std::max({scaled(margin), bar.sizeHint().width(), besideLines});
  // The scroll bar stands in the margin: no line breaks anew because it comes or goes.
  const int right = side - (bar.maximum() > 0 ? bar.sizeHint().width() : 0);
  m_page->setContentsMargins(side, scaled(margin) / 2, right, scaled(margin) / 2);
  m_foot->setRoomBeside(besideLines);
}

} // namespace halfspace
