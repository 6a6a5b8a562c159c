#include "widgets/view/scene_frame.h"

#include "widgets/colors.h"
#include "widgets/numbers/number_card.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_view.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

/// Between what lies over the view and its edges, in pixels.
constexpr int edgeGap = 10;
constexpr int toolGap = 6;
/// An icon's side at a text scale of 1, likewise; larger icons would take too much of the view.
constexpr int iconSide = 18;
constexpr double largestIconScale = 1.5;

} // namespace

SceneFrame::SceneFrame(SceneView &view, NumberCard &card, QWidget *parent)
    : QWidget(parent), m_view(view), m_card(card), m_tools(new QWidget), m_notice(new QLabel(this)) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(&m_view);
  m_card.setParent(this);
  m_tools->setParent(this);
  auto *column = new QVBoxLayout(m_tools);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(toolGap);
  m_card.installEventFilter(this);
  m_notice->setObjectName("sceneNotice");
  m_notice->setWordWrap(true);
  m_notice->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_notice->hide();
  connect(&m_view.drawing(), &SceneDrawing::noticeChanged, this, &SceneFrame::showNotice);
}

void SceneFrame::addTool(QAction &action, ToolIcon icon) {
  auto *button = new QToolButton;
  button->setObjectName("sceneTool");
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  button->setFocusPolicy(Qt::NoFocus); // the keys stay with the view
  const QString keys = action.shortcut().toString(QKeySequence::NativeText);
  const QString name = action.text().remove('&');
  button->setToolTip(keys.isEmpty() ? name : tr("%1 (%2)", "a tool and its key").arg(name, keys));
  button->setAccessibleName(name);
  button->setCheckable(action.isCheckable());
  button->setChecked(action.isChecked());
  connect(button, &QToolButton::clicked, &action, &QAction::trigger);
  connect(&action, &QAction::toggled, button, &QToolButton::setChecked);
  m_tools->layout()->addWidget(button);
  m_buttons.push_back({button, icon});
  arrange();
}

void SceneFrame::setFlatView(FlatView &flat) {
  m_flat = &flat;
  const bool isShown = flat.hasPicture();
  flat.setParent(this);
  flat.setVisible(isShown);
  connect(&flat, &FlatView::sizeChanged, this, &SceneFrame::arrange);
  arrange();
}

void SceneFrame::setTheme(const Theme &theme) {
  const int side = qRound(iconSide * std::min(theme.textScale, largestIconScale));
  for (const auto &[button, icon] : m_buttons) {
    button->setIcon(iconOf(icon, toQColor(theme.ink)));
    button->setIconSize({side, side});
  }
  arrange();
}

void SceneFrame::showNotice(const QString &words) {
  m_notice->setText(words);
  m_notice->setVisible(!words.isEmpty());
  placeNotice();
}

void SceneFrame::placeNotice() {
  const int room = std::max(0, m_tools->geometry().left() - 2 * edgeGap);
  const int noticeWidth = std::min(m_notice->sizeHint().width(), room);
  m_notice->setGeometry(edgeGap, edgeGap, noticeWidth, m_notice->heightForWidth(noticeWidth));
  m_notice->raise();
}

void SceneFrame::resizeEvent(QResizeEvent *event) {
  QWidget::resizeEvent(event);
  arrange();
}

bool SceneFrame::eventFilter(QObject *watched, QEvent *event) {
  if (event->type() == QEvent::LayoutRequest)
    arrange();
  return QWidget::eventFilter(watched, event);
}

void SceneFrame::arrange() {
  const QSize tools = m_tools->sizeHint();
  m_tools->setGeometry(width() - tools.width() - edgeGap, edgeGap, tools.width(), tools.height());
  placeNotice();
  std::vector<QRect> covered{m_tools->geometry()};
  int cardRoom = width() - 2 * edgeGap;
  if (m_flat && m_flat->hasPicture()) {
    const QSize flat = m_flat->sizeIn(size() - QSize(2 * edgeGap, 2 * edgeGap));
    const QRect corner(QPoint(width() - flat.width() - edgeGap, height() - flat.height() - edgeGap), flat);
    m_flat->setGeometry(corner);
    m_flat->raise();
    covered.push_back(corner);
    cardRoom = corner.left() - 2 * edgeGap;
  }
  const int cardWidth = std::min(m_card.sizeHint().width(), cardRoom);
  const int cardHeight =
      m_card.hasHeightForWidth() ? m_card.heightForWidth(cardWidth) : m_card.sizeHint().height();
  m_card.setGeometry(edgeGap, height() - cardHeight - edgeGap, cardWidth, cardHeight);
  m_card.raise();
  m_tools->raise();
  // The card comes and goes with the selection; the figure does not make way for it each time.
  const QSize room = m_card.usualSize().boundedTo(size() / 2);
  covered.emplace_back(edgeGap, height() - room.height() - edgeGap, std::min(room.width(), cardRoom),
                       room.height());
  m_view.setCovered(covered);
}

} // namespace halfspace
