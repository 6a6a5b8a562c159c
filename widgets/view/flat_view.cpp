#include "widgets/view/flat_view.h"

#include "lessons/scene/change_words.h"
#include "lessons/scene/hand/snapping.h"
#include "lessons/scene/scene_letters.h"
#include "widgets/colors.h"
#include "widgets/mouse_place.h"
#include "widgets/picture/hand/grips.h"
#include "widgets/picture/hand/mark_picker.h"
#include "widgets/view/staged_scene.h"

#include <QAction>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// In a small picture type and lines are a little smaller than in the scene.
constexpr double smallness = 0.8;
/// … where it is lower than this, in pixels, even more, down to a part that can still be read.
constexpr double roomyHeight = 240;
constexpr double leastPart = 0.8;

} // namespace

FlatView::FlatView(SessionModel &model, const Typesetter &typesetter, QWidget *parent)
    : QFrame(parent), m_model(model), m_painter(typesetter), m_theme(themes().front()),
      m_unfolded(new QAction(tr("Flat &Picture"), this)), m_title(new QToolButton(this)) {
  setObjectName("flatView");
  setMouseTracking(true);
  setAccessibleName(tr("Flat picture"));
  m_unfolded->setCheckable(true);
  m_unfolded->setChecked(true);
  m_title->setObjectName("flatTitle");
  m_title->setText(tr("From the side"));
  m_title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_title->setAutoRaise(true);
  m_title->setArrowType(Qt::DownArrow);
  m_title->setFocusPolicy(Qt::NoFocus); // the keys stay with the scene; the menu has one for it
  connect(m_title, &QToolButton::clicked, m_unfolded, &QAction::toggle);
  connect(m_unfolded, &QAction::toggled, this, [this](bool on) {
    m_title->setArrowType(on ? Qt::DownArrow : Qt::UpArrow);
    emit sizeChanged();
  });
  connect(&m_model, &SessionModel::outcomeChanged, this, &FlatView::takeOutcome);
  connect(&m_model.history(), &SessionHistory::gestureChanged, this, &FlatView::takeOutcome);
  connect(&m_model.history(), &SessionHistory::gestureSettled, this, &FlatView::letGo);
  takeOutcome();
}

void FlatView::setTheme(const Theme &theme) {
  m_theme = theme;
  m_title->adjustSize();
  update();
}

void FlatView::setSizeScale(double scale) {
  m_sizeScale = scale;
  takeView();
  emit sizeChanged();
}

void FlatView::setHighlighted(std::set<std::string> markIds) {
  m_highlighted = std::move(markIds);
  update();
}

QSize FlatView::sizeIn(const QSize &room) const {
  const QSize title = m_title->sizeHint() + QSize(2 * frameWidth(), 2 * frameWidth());
  const auto size = flatSizeIn({room.width(), room.height()}, m_sizeScale);
  if (!m_unfolded->isChecked() || !size)
    return title;
  return QSize(qRound(size->x), qRound(size->y)).expandedTo(title);
}

bool FlatView::isOpen() const { return height() > m_title->height() + 2 * frameWidth(); }

void FlatView::takeOutcome() {
  const auto &flat = m_model.lesson().flat;
  const bool hadPicture = hasPicture();
  if (m_model.history().isHeldBy(m_held))
    m_frame = m_drag->frame(); // the page keeps still under the hand
  else
    m_frame = flat ? flatFrame(*flat, m_model.session().scene) : std::nullopt;
  setVisible(hasPicture());
  if (hadPicture != hasPicture())
    emit sizeChanged();
  if (!hasPicture())
    return;
  const Stage &stage = m_model.stage();
  m_whole = laidFlat(toStage(m_model.figure(), stage), *m_frame);
  m_content.stage = stage;
  m_content.figure = laidFlat(toStage(m_model.shown().figure, stage), *m_frame);
  describe();
  // What is held must not jump under the hand.
  if (!m_drag && (!m_model.history().inGesture() || !showsAll(m_whole, m_view)))
    takeView();
  update();
}

void FlatView::takeView() {
  const double part = std::clamp(height() / (roomyHeight * m_sizeScale), leastPart, 1.0);
  const double ratio = m_sizeScale * smallness * part;
  m_view.size = {std::max(1, width()), std::max(1, height())};
  m_view.pixelRatio = ratio;
  m_view.covered = {{{0, 0}, {m_title->width(), m_title->height()}}};
  m_view.camera = flatCamera(m_whole, m_view);
}

void FlatView::describe() {
  const FlatPage &page = *m_model.lesson().flat;
  const Scene &scene = m_model.session().scene;
  setAccessibleDescription(tr("The scene seen from the side: %1 points up and %2 to the right, both in their "
                              "true length. A plane with the normal %1 is a level line.")
                               .arg(QString::fromStdString(shortName(scene, page.up)),
                                    QString::fromStdString(shortName(scene, page.right))));
}

void FlatView::paintEvent(QPaintEvent *event) {
  QFrame::paintEvent(event);
  if (!isOpen() || !hasPicture())
    return;
  QPainter painter(this);
  painter.setClipRect(contentsRect());
  SceneContent content = m_content;
  content.figure = clippedTo(m_view, std::move(content.figure));
  content.highlighted = m_highlighted;
  if (!m_hovered.empty())
    content.highlighted.insert(m_hovered);
  m_painter.paint(painter, content, m_theme, m_view);
}

void FlatView::resizeEvent(QResizeEvent *event) {
  QFrame::resizeEvent(event);
  m_title->adjustSize();
  m_title->move(frameWidth(), frameWidth());
  takeView();
}

std::optional<Handle> FlatView::handleAt(const QPointF &place) const {
  const std::string upwards = fullName(m_model.session().scene, m_model.lesson().flat->up);
  const std::vector<Handle> handles = handlesOf(stagedScene(m_model, m_content.stage));
  const Handle *handle = handleOnPage({place.x(), place.y()}, handles, upwards, *m_frame, m_view,
                                      missMargin * m_view.pixelRatio);
  return handle ? std::optional(*handle) : std::nullopt;
}

void FlatView::mousePressEvent(QMouseEvent *event) {
  event->accept(); // never the scene's below
  if (!isOpen() || m_drag || event->button() != Qt::LeftButton)
    return;
  const QPointF at = mousePlace(*event);
  const auto handle = handleAt(at);
  if (!handle)
    return;
  const GestureToken held = m_model.history().beginGesture(
      QString::fromStdString(wordsForMoving(m_model.session().scene, *handle)));
  m_drag.emplace(stagedScene(m_model, m_content.stage), *handle, *m_frame, glm::dvec2(at.x(), at.y()),
                 askedOf(m_model, *handle));
  m_held = held;
  grabKeyboard();
  setCursor(Qt::ClosedHandCursor);
  emit handleGrabbed(QString::fromStdString(handle->id));
}

void FlatView::mouseReleaseEvent(QMouseEvent *event) {
  if (!m_drag || event->button() != Qt::LeftButton)
    return;
  m_model.history().endGesture(m_held);
  letGo();
}

void FlatView::keyPressEvent(QKeyEvent *event) {
  if (!m_drag || event->key() != Qt::Key_Escape)
    return QFrame::keyPressEvent(event);
  m_model.history().cancelGesture(m_held);
  letGo();
}

void FlatView::letGo() {
  if (!m_drag)
    return;
  m_drag.reset();
  m_held = GestureToken::Nobodys;
  releaseKeyboard();
  unsetCursor();
  takeOutcome();
}

void FlatView::mouseMoveEvent(QMouseEvent *event) {
  if (!isOpen())
    return;
  const QPointF at = mousePlace(*event);
  if (m_drag) {
    const bool isFree =
        event->modifiers() & (Qt::ControlModifier | Qt::AltModifier) || !m_model.snapping().isOn;
    if (const auto move =
            m_drag->moveTo({at.x(), at.y()}, isFree ? finestStep : m_model.snapping().step, m_view))
      m_model.history().moveGesture(
          m_held, ChangeObject{m_drag->handle().object, fromStage(move->object, m_content.stage)});
    return;
  }
  if (handleAt(at))
    setCursor(Qt::OpenHandCursor);
  else
    unsetCursor();
  hover(markUnder({at.x(), at.y()}, m_content.figure, m_view.camera, m_view.size, m_view.pixelRatio));
}

void FlatView::leaveEvent(QEvent *event) {
  hover({});
  QFrame::leaveEvent(event);
}

void FlatView::hover(const std::string &mark) {
  if (mark == m_hovered)
    return;
  m_hovered = mark;
  update();
  emit markHovered(QString::fromStdString(mark));
}

} // namespace halfspace
