#include "widgets/view/flat_view.h"

#include "lessons/scene/change_words.h"
#include "widgets/colors.h"
#include "widgets/mouse_place.h"
#include "widgets/picture/hand/grips.h"
#include "widgets/view/snapping_keys.h"
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

/// For those who do not see it.
QString descriptionOf(const Lesson &lesson, const Scene &scene) {
  return FlatView::tr("The scene seen from the side: %1 points up and %2 to the right, both in their "
                      "true length. A plane with the normal %1 is a level line.")
      .arg(QString::fromStdString(shortName(scene, lesson.flat->up)),
           QString::fromStdString(shortName(scene, lesson.flat->right)));
}

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
  fit();
  emit sizeChanged();
}

void FlatView::setHighlighted(const std::set<std::string> &markIds) {
  if (markIds == m_highlighted)
    return;
  m_highlighted = markIds;
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
  const bool hadPicture = hasPicture();
  takePicture();
  setVisible(hasPicture());
  if (hadPicture != hasPicture())
    emit sizeChanged();
  if (!hasPicture())
    return;
  if (!m_model.history().inGesture())
    setAccessibleDescription(descriptionOf(m_model.lesson(), m_model.session().scene));
  // What is held must not jump under the hand.
  if (isOpen() && !m_drag && (!m_model.history().inGesture() || !m_picture->isInView(m_view)))
    fit();
  update();
}

void FlatView::takePicture() {
  const auto frame = m_model.history().isHeldBy(m_held)
                         ? std::optional(m_drag->frame()) // it keeps still under the hand
                         : flatFrame(m_model.lesson().flat, m_model.session().scene);
  m_picture.reset();
  if (frame)
    m_picture.emplace(*frame, m_model.stage(), m_model.figure(), m_model.shown().figure);
}

void FlatView::fit() {
  if (!isOpen() || !hasPicture())
    return;
  const double part = std::clamp(height() / (roomyHeight * m_sizeScale), leastPart, 1.0);
  m_view = m_picture->fitted({{},
                              {std::max(1, width()), std::max(1, height())},
                              m_sizeScale * smallness * part,
                              {{{0, 0}, {m_title->width(), m_title->height()}}}});
}

void FlatView::paintEvent(QPaintEvent *event) {
  QFrame::paintEvent(event);
  if (!isOpen() || !hasPicture())
    return;
  QPainter painter(this);
  painter.setClipRect(contentsRect());
  SceneContent content = m_picture->seenFrom(m_view);
  content.highlighted = m_highlighted;
  m_painter.paint(painter, content, m_theme, view());
}

void FlatView::resizeEvent(QResizeEvent *event) {
  QFrame::resizeEvent(event);
  m_title->adjustSize();
  m_title->move(frameWidth(), frameWidth());
  fit();
}

void FlatView::mousePressEvent(QMouseEvent *event) {
  event->accept(); // never the scene's below
  if (!isOpen() || m_drag || event->button() != Qt::LeftButton)
    return;
  const QPointF place = mousePlace(*event);
  const glm::dvec2 at(place.x(), place.y());
  const auto handle = handleAt(at);
  if (!handle)
    return;
  const GestureToken held = m_model.history().beginGesture(
      QString::fromStdString(wordsForMoving(m_model.session().scene, *handle)));
  m_drag.emplace(stagedScene(m_model, m_picture->stage()), *handle, m_picture->frame(), at,
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
  const QPointF place = mousePlace(*event);
  const glm::dvec2 at(place.x(), place.y());
  if (m_drag) {
    const Rational &step = m_model.snapping().dragStep(suspendsSnapping(event->modifiers()));
    if (const auto move = m_drag->moveTo(at, step, view()))
      m_model.history().moveGesture(
          m_held, ChangeObject{m_drag->handle().object, fromStage(move->object, m_picture->stage())});
    return;
  }
  if (handleAt(at))
    setCursor(Qt::OpenHandCursor);
  else
    unsetCursor();
  hover(m_picture->markAt(at, m_view));
}

void FlatView::leaveEvent(QEvent *event) {
  hover({});
  QFrame::leaveEvent(event);
}

std::optional<Handle> FlatView::handleAt(glm::dvec2 pixel) const {
  const std::string upwards = fullName(m_model.session().scene, m_model.lesson().flat->up);
  const std::vector<Handle> handles = handlesOf(stagedScene(m_model, m_picture->stage()));
  const Handle *handle =
      handleOnPage(pixel, handles, upwards, m_picture->frame(), m_view, missMargin * m_view.pixelRatio);
  return handle ? std::optional(*handle) : std::nullopt;
}

void FlatView::hover(const std::string &mark) {
  if (mark == m_hovered)
    return;
  m_hovered = mark;
  emit markHovered(QString::fromStdString(mark));
}

} // namespace halfspace
