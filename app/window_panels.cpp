// The panels of the window: what each is made of and where it stands.
#include "app/main_window.h"
#include "widgets/lesson/lesson_panel.h"
#include "widgets/numbers/inspector.h"
#include "widgets/working/working_practice.h"

#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

// How much of the window the panels take at first.
constexpr double workingWidth = 0.31;
constexpr double workingHeight = 0.5;
constexpr double numbersHeight = 0.375;
constexpr double lessonsWidth = 0.176;
constexpr double lessonWidth = 0.51;
constexpr double lessonHeight = 0.325;
/// In pixels: a title and a few lines of words, and the way on.
constexpr int leastLessonHeight = 225;

/// Both sides of a title in the list of lessons, as in the style sheet, in em.
constexpr double titlePadding = 2 * 0.45;

/// Wraps titles within the style sheet's padding, which Qt leaves out of account.
class TitleDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override {
    QStyleOptionViewItem narrower = option;
    const double em = QFontInfo(option.font).pixelSize();
    // There may be a scroll bar later: a title is not measured anew for it.
    const int scrollBar =
        option.widget->style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, option.widget);
    narrower.rect.setWidth(option.rect.width() - static_cast<int>(std::ceil(titlePadding * em)) - scrollBar);
    return QStyledItemDelegate::sizeHint(narrower, index);
  }
};

} // namespace

QDockWidget *MainWindow::addPanel(const QString &title, const char *name, QWidget *content,
                                  Qt::DockWidgetArea area) {
  auto *dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::createPanels() {
  m_caseLabel = new QLabel;
  m_caseLabel->setObjectName("case");
  m_caseLabel->setWordWrap(true);
  m_caseLabel->setTextFormat(Qt::PlainText);
  auto *center = new QWidget;
  auto *layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_scene, 1);
  layout->addWidget(m_caseLabel);
  setCentralWidget(center);

  m_practice = new WorkingPractice(*m_typesetter);
  m_working = &m_practice->panel();
  m_inspector = new Inspector(m_model, *m_typesetter);
  m_lessonPanel = new LessonPanel(*m_typesetter);
  createLessonList();
  connectWorking();
  connect(m_lessonPanel, &LessonPanel::stepRequested, this, [this](int step) { m_model.setStep(step); });
  connect(m_lessonPanel, &LessonPanel::predictionChosen, this, &MainWindow::choose);

  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  addPanel(tr("Working"), "workingDock", m_practice, Qt::RightDockWidgetArea);
  addPanel(tr("Numbers"), "numbersDock", m_inspector, Qt::RightDockWidgetArea);
  addPanel(tr("Lessons"), "lessonsDock", m_lessonList, Qt::BottomDockWidgetArea);
  addPanel(tr("Lesson"), "lessonDock", m_lessonPanel, Qt::BottomDockWidgetArea);
}

void MainWindow::connectWorking() {
  m_working->setWholeWorking([this] { return workingOf(m_model.evaluation()); });
  connect(m_working, &WorkingPanel::markHovered, this, &MainWindow::hoverMark);
  connect(m_scene, &SceneView::dismissed, m_working, &WorkingPanel::endTrace);
  connect(m_working, &WorkingPanel::traceChanged, this, &MainWindow::showHighlights);
  connect(m_working, &WorkingPanel::coordinateTyped, this,
          [this](const CoordinateSource &source, const Rational &value) {
            if (const auto number = numberOf(source))
              m_editor.change(*number, value);
          });
  connect(m_working, &WorkingPanel::coordinateStepped, this,
          [this](const CoordinateSource &source, int steps) {
            if (const auto number = numberOf(source))
              m_editor.step(*number, steps);
          });
  connect(m_working, &WorkingPanel::scrubStarted, this, [this](const CoordinateSource &source) {
    if (const auto number = numberOf(source))
      m_editor.beginScrub(*number);
  });
  connect(m_working, &WorkingPanel::scrubbed, this, [this](int steps) { m_editor.scrub(steps); });
  connect(m_working, &WorkingPanel::scrubEnded, this, [this](bool keep) { m_editor.endScrub(keep); });
}

std::optional<CoordinateNumber> MainWindow::numberOf(const CoordinateSource &source) const {
  const auto id = coordinateOf(m_model.session().scene, source);
  return id ? std::optional(CoordinateNumber{*id, source.component.value_or(0)}) : std::nullopt;
}

void MainWindow::createLessonList() {
  m_lessonList = new QListWidget;
  m_lessonList->setObjectName("lessonList");
  m_lessonList->setItemDelegate(new TitleDelegate(m_lessonList));
  m_lessonList->setWordWrap(true);
  m_lessonList->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_lessonList->setTextElideMode(Qt::ElideNone);
  m_lessonList->setResizeMode(QListView::Adjust); // wrap anew at every width
  m_lessonList->setAccessibleName(tr("Lessons"));
  for (const Lesson &lesson : m_model.library().lessons) {
    auto *item = new QListWidgetItem(QString::fromStdString(lesson.title), m_lessonList);
    item->setData(Qt::UserRole, QString::fromStdString(lesson.id));
    item->setToolTip(QString::fromStdString(lesson.id));
  }
  const auto openLessonOf = [this](const QListWidgetItem *item) {
    m_model.openLesson(item->data(Qt::UserRole).toString().toStdString());
  };
  connect(m_lessonList, &QListWidget::itemClicked, this, openLessonOf);
  connect(m_lessonList, &QListWidget::itemActivated, this, openLessonOf);
}

void MainWindow::arrangePanels() {
  const auto dock = [this](const char *name) { return findChild<QDockWidget *>(name); };
  QDockWidget *working = dock("workingDock");
  QDockWidget *numbers = dock("numbersDock");
  QDockWidget *lessons = dock("lessonsDock");
  QDockWidget *lesson = dock("lessonDock");
  splitDockWidget(working, numbers, Qt::Vertical);
  splitDockWidget(lessons, lesson, Qt::Horizontal);
  const auto part = [](int whole, double of) { return static_cast<int>(whole * of); };
  resizeDocks({working}, {part(width(), workingWidth)}, Qt::Horizontal);
  resizeDocks({working, numbers}, {part(height(), workingHeight), part(height(), numbersHeight)},
              Qt::Vertical);
  resizeDocks({lessons, lesson}, {part(width(), lessonsWidth), part(width(), lessonWidth)}, Qt::Horizontal);
  resizeDocks({lessons}, {std::max(part(height(), lessonHeight), leastLessonHeight)}, Qt::Vertical);
}

} // namespace halfspace
