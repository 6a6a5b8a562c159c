#include "widgets/view/object_hand.h"

#include "lessons/scene/scene_looks.h"
#include "lessons/term/plain_text.h"
#include "widgets/mouse_place.h"
#include "widgets/picture/hand/tool_ghost.h"
#include "widgets/view/key_steps.h"
#include "widgets/view/object_tool_words.h"
#include "widgets/view/pointer_hint.h"
#include "widgets/view/snapping_keys.h"

#include <QKeyEvent>

#include <utility>

namespace halfspace {
namespace {

/// What of the scene a click would take, or lie on; empty for nothing.
std::string takenMark(const std::optional<ToolPick> &pick) {
  return !pick ? std::string() : pick->entry ? pick->entry->on : pick->name;
}

/// Whether a key that a window may have for something else belongs to the tool.
bool isToolKey(int key) {
  switch (key) {
  case Qt::Key_Escape:
  case Qt::Key_Backspace:
  case Qt::Key_Return:
  case Qt::Key_Enter:
  case Qt::Key_Left:
  case Qt::Key_Right:
  case Qt::Key_Up:
  case Qt::Key_Down:
  case Qt::Key_PageUp:
  case Qt::Key_PageDown:
    return true;
  default:
    return false;
  }
}

} // namespace

ObjectHand::ObjectHand(QWidget &view, const ViewScreen &screen, Viewpoint &viewpoint, SessionModel &model,
                       DrawnFigure &drawn, SceneInput &input)
    : m_view(view), m_screen(screen), m_viewpoint(viewpoint), m_model(model), m_drawn(drawn), m_input(input),
      m_hint(new PointerHint(view)) {
  m_view.installEventFilter(this); // behind that of the input: events come here first
  connect(&m_model, &SessionModel::lessonChanged, this, &ObjectHand::cancel);
  // What lies under the pointer is another place then.
  connect(&m_viewpoint, &Viewpoint::moved, this, &ObjectHand::aim);
  connect(&m_viewpoint, &Viewpoint::changed, this, &ObjectHand::aim);
}

void ObjectHand::begin(ToolObject object) {
  m_input.setGrabbing(false);
  m_view.setFocus();
  m_view.setCursor(Qt::CrossCursor);
  go({object});
  emit toolChanged();
}

void ObjectHand::cancel() {
  if (!m_tool)
    return;
  m_tool.reset();
  setNext({});
  m_input.setGrabbing(true);
  m_view.unsetCursor();
  emit toolChanged();
  emit promptChanged();
}

std::optional<ToolObject> ObjectHand::tool() const {
  return m_tool ? std::optional(m_tool->object) : std::nullopt;
}

QString ObjectHand::prompt() const {
  const auto wish = m_tool ? wishOf(*m_tool) : std::nullopt;
  if (!wish)
    return {};
  const bool isSeenEndOn = m_pointer && !m_next && wish->kind != ToolWish::Kind::OnObject &&
                           !canPlace(m_room, m_viewpoint.camera());
  return isSeenEndOn ? endOnPrompt() : promptOf(*m_tool);
}

void ObjectHand::takeOutcome() {
  if (!m_tool)
    return;
  if (auto tool = followed(*m_tool, m_model.evaluation()))
    go(std::move(*tool));
  else
    cancel();
}

bool ObjectHand::eventFilter(QObject *watched, QEvent *event) {
  if (!m_tool)
    return QObject::eventFilter(watched, event);
  switch (event->type()) {
  case QEvent::MouseButtonPress:
  case QEvent::MouseButtonDblClick: // of two quick clicks the second
    press(static_cast<QMouseEvent &>(*event));
    return false; // the picture can be turned and moved all the same
  case QEvent::MouseMove:
    move(static_cast<QMouseEvent &>(*event));
    return false;
  case QEvent::MouseButtonRelease:
    release(static_cast<QMouseEvent &>(*event));
    return false;
  case QEvent::Leave:
    m_pointer.reset();
    setNext({});
    return false;
  case QEvent::ShortcutOverride:
    if (!isToolKey(static_cast<QKeyEvent &>(*event).key()))
      return false;
    event->accept();
    return true;
  case QEvent::KeyPress:
    return pressKey(static_cast<QKeyEvent &>(*event));
  case QEvent::KeyRelease:
    if (static_cast<QKeyEvent &>(*event).key() == Qt::Key_Shift)
      turnRoom(false);
    return false;
  default:
    return QObject::eventFilter(watched, event);
  }
}

void ObjectHand::press(const QMouseEvent &event) { m_press = {event.button(), mousePlace(event)}; }

void ObjectHand::move(const QMouseEvent &event) {
  const QPointF place = mousePlace(event);
  if (event.buttons() != Qt::NoButton) {
    m_press.hasMoved = m_press.hasMoved || (place - m_press.place).manhattanLength() > SceneInput::clickSlop;
    return;
  }
  m_view.setCursor(Qt::CrossCursor); // each gesture of the picture leaves the usual one
  m_pointer = {place, suspendsSnapping(event.modifiers())};
  aim();
}

void ObjectHand::release(const QMouseEvent &event) {
  const Press press = std::exchange(m_press, {});
  if (event.button() != press.button || press.hasMoved)
    return;
  m_pointer = {mousePlace(event), suspendsSnapping(event.modifiers())};
  aim();
  if (press.button == Qt::LeftButton)
    takeNext();
  else if (press.button == Qt::RightButton)
    stepBack();
}

bool ObjectHand::pressKey(const QKeyEvent &event) {
  switch (event.key()) {
  case Qt::Key_Escape:
  case Qt::Key_Backspace:
    stepBack();
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    if (m_pointer && canClose(*m_tool)) // whoever has clicked the corners has no more of them
      goOn(withClosedCorners(*m_tool));
    else
      takeNext();
    return true;
  case Qt::Key_Shift:
    turnRoom(true);
    return true;
  default:
    return stepPlace(event);
  }
}

bool ObjectHand::stepPlace(const QKeyEvent &event) {
  const ToolWish::Kind wish = wishOf(*m_tool)->kind;
  if (wish == ToolWish::Kind::OnObject)
    return false;
  Handle handle;
  handle.at = nextPlace();
  if (wish == ToolWish::Kind::Radius)
    handle.axis = {1, 0, 0};
  const int key = m_room.isUpright ? verticalKey(event.key()) : event.key();
  const auto stepped =
      steppedPlace(handle, key, event.modifiers(), m_model.snapping().step, m_viewpoint.camera());
  if (!stepped)
    return false;
  m_room.at = *stepped;
  m_pointer.reset();
  setNext(pickAt(*stepped, *m_tool, toolScene()));
  return true;
}

void ObjectHand::turnRoom(bool turned) {
  const ToolWish wish = *wishOf(*m_tool);
  const bool isUpright = roomFor(wish, m_model.stage()).isUpright != turned;
  if (wish.kind != ToolWish::Kind::Point || isUpright == m_room.isUpright)
    return;
  m_room = {nextPlace(), isUpright};
  aim();
}

ExactVec3 ObjectHand::nextPlace() const {
  return m_next ? toStage(m_next->at, CoordinateRole::Position, m_model.stage()) : m_room.at;
}

void ObjectHand::aim() {
  if (!m_tool || !m_pointer)
    return;
  setNext(pickUnder(m_screen.pixelAt(m_pointer->place), *m_tool, toolScene(), m_room, m_viewpoint.view()));
}

void ObjectHand::setNext(std::optional<ToolPick> next) {
  const std::string before = takenMark(std::exchange(m_next, std::move(next)));
  if (const std::string now = takenMark(m_next); now != before)
    emit markHovered(QString::fromStdString(now));
  show();
}

void ObjectHand::takeNext() {
  if (m_next)
    goOn(withPick(*m_tool, *m_next));
}

void ObjectHand::goOn(ObjectTool tool) {
  if (wishOf(tool))
    go(std::move(tool));
  else
    make(tool);
}

void ObjectHand::stepBack() {
  if (m_tool->picks.empty())
    cancel();
  else
    go(withoutLastPick(*m_tool));
}

void ObjectHand::go(ObjectTool tool) {
  const ToolWish wish = *wishOf(tool);
  m_room = roomFor(wish, m_model.stage());
  if (wish.kind == ToolWish::Kind::Point && !tool.picks.empty()) { // keys go on below what was taken last
    const ExactVec3 last = toStage(tool.picks.back().at, CoordinateRole::Position, m_model.stage());
    m_room.at = {last.x, last.y, m_room.at.z};
  }
  m_tool = std::move(tool);
  setNext({});
  aim();
  emit promptChanged();
}

void ObjectHand::make(const ObjectTool &tool) {
  const std::vector<Entry> entries = entriesOf(tool, m_model.session().scene);
  if (entries.empty())
    return cancel(); // a point that is there already
  std::vector<Edit> edits;
  edits.reserve(entries.size());
  for (const Entry &entry : entries)
    edits.emplace_back(AddEntry{m_model.session().scene.entries.size() + edits.size(), entry});
  const std::string name = plainText(symbolOf(entries.back().name));
  cancel(); // first: it does not go on with what it has made
  const QString refusal = m_model.history().editTogether(keepingColors(m_model.session().scene, edits),
                                                         tr("Add %1").arg(QString::fromStdString(name)));
  if (!refusal.isEmpty())
    emit refused(refusal);
}

void ObjectHand::show() {
  m_drawn.setGhost(m_tool ? ghostOf(*m_tool, m_next, m_model.evaluation(), m_model.stage()) : Figure());
  std::optional<QPoint> beside;
  if (m_pointer)
    beside = m_pointer->place.toPoint();
  else if (const auto pixel = m_viewpoint.camera().project(toDouble(nextPlace()), m_screen.size());
           m_next && pixel)
    beside = (QPointF(pixel->x, pixel->y) / m_view.devicePixelRatioF()).toPoint();
  m_hint->showAt(beside.value_or(QPoint()), beside ? prompt() : QString());
}

ToolScene ObjectHand::toolScene() const {
  return {m_model.evaluation(), m_drawn.figure(), m_model.stage(),
          m_model.snapping().dragStep(m_pointer && m_pointer->isSuspended)};
}

} // namespace halfspace
