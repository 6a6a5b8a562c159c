#include "app/export/preview_labels.h"

#include "app/export/preview_pane.h"
#include "lessons/lesson/prose.h"
#include "lessons/scene/change_words.h"
#include "widgets/session_model.h"

#include <QKeySequence>
#include <QMenu>

namespace halfspace {

PreviewLabels::PreviewLabels(SessionModel &model, PreviewPane &pane, QObject *parent)
    : QObject(parent), m_model(model), m_pane(pane), m_stepsBefore(model.history().index()) {
  connect(&pane, &PreviewPane::hovered, this, &PreviewLabels::hover);
  connect(&pane, &PreviewPane::pressed, this, &PreviewLabels::take);
  connect(&pane, &PreviewPane::dragged, this, &PreviewLabels::move);
  connect(&pane, &PreviewPane::released, this, &PreviewLabels::letGo);
  connect(&pane, &PreviewPane::menuWanted, this, &PreviewLabels::openMenu);
  connect(&pane, &PreviewPane::removeWanted, this, [this] {
    if (!m_chosen.empty())
      change(hideLabel(m_model.session().scene, m_chosen, true));
  });
}

glm::dvec2 PreviewLabels::pixelAt(QPointF part) const {
  return m_shapes->page.low + glm::dvec2(part.x(), part.y()) * m_shapes->page.extent();
}

std::string PreviewLabels::markAt(QPointF part) const {
  const Shape *label = m_shapes ? labelUnder(pixelAt(part), m_shapes->list) : nullptr;
  return label ? label->mark : std::string();
}

void PreviewLabels::hover(QPointF part) { m_pane.setHand(!markAt(part).empty(), false); }

void PreviewLabels::take(QPointF part) {
  m_held = m_shapes ? takeLabel(m_shapes->list, pixelAt(part)) : std::nullopt;
  m_chosen = m_held ? m_held->mark : std::string();
  if (!m_held)
    return;
  m_pane.setHand(true, true);
  m_gesture = m_model.history().beginGesture(wordsFor(moveLabel(*m_held, m_held->grip)));
}

void PreviewLabels::move(QPointF part) {
  if (m_held)
    m_model.history().moveGesture(m_gesture, moveLabel(*m_held, pixelAt(part)));
}

void PreviewLabels::letGo() {
  if (!m_held)
    return;
  m_held.reset();
  m_pane.setHand(true, false);
  m_model.history().endGesture(m_gesture);
}

bool PreviewLabels::putBackHeld() {
  if (!m_held)
    return false;
  m_held.reset();
  m_pane.setHand(true, false);
  m_model.history().cancelGesture(m_gesture);
  return true;
}

void PreviewLabels::openMenu(QPointF part, const QPoint &at) {
  QMenu menu;
  if (const std::string mark = markAt(part); !mark.empty()) {
    const Scene &scene = m_model.session().scene;
    connect(menu.addAction(tr("&Hide the Label")), &QAction::triggered, this,
            [this, mark] { change(hideLabel(m_model.session().scene, mark, true)); });
    QAction *back = menu.addAction(tr("&Put the Label Back"));
    back->setEnabled(scene.labels.contains(mark));
    connect(back, &QAction::triggered, this, [this, mark] { change(putLabelBack(mark)); });
    menu.addSeparator();
  }
  addPutAllBack(menu);
  menu.exec(at);
}

void PreviewLabels::fillMenu(QMenu &menu) {
  menu.clear();
  const auto add = [&](const std::string &mark, const QString &text, bool isHidden) {
    QAction *item = menu.addAction(text);
    item->setCheckable(true);
    item->setChecked(!isHidden);
    connect(item, &QAction::triggered, this,
            [this, mark](bool isShown) { change(hideLabel(m_model.session().scene, mark, !isShown)); });
  };
  if (m_shapes)
    forEach<LabelShape>(*m_shapes->list.layer(Layer::Labels),
                        [&](const Shape &shape, const LabelShape &label) {
                          if (label.anchor)
                            add(shape.mark, QString::fromStdString(plainProse(label.latex)), false);
                        });
  for (const auto &[mark, label] : m_model.session().scene.labels)
    if (label.isHidden)
      add(mark, QString::fromStdString(mark), true);
  menu.addSeparator();
  addUndoAndRedo(menu);
  addPutAllBack(menu);
}

void PreviewLabels::addUndoAndRedo(QMenu &menu) {
  const auto add = [&](const QString &words, QKeySequence::StandardKey key, bool isEnabled) {
    QAction *item = menu.addAction(words + '\t' + QKeySequence(key).toString(QKeySequence::NativeText));
    item->setEnabled(isEnabled);
    return item;
  };
  connect(add(tr("&Undo"), QKeySequence::Undo, canUndo()), &QAction::triggered, this, &PreviewLabels::undo);
  connect(add(tr("&Redo"), QKeySequence::Redo, canRedo()), &QAction::triggered, this, &PreviewLabels::redo);
}

void PreviewLabels::addPutAllBack(QMenu &menu) {
  QAction *all = menu.addAction(tr("Put &All Labels Back"));
  all->setEnabled(!m_model.session().scene.labels.empty());
  connect(all, &QAction::triggered, this, [this] {
    std::vector<Edit> edits;
    for (const auto &[mark, label] : m_model.session().scene.labels)
      edits.emplace_back(putLabelBack(mark));
    m_model.history().editTogether(edits, tr("Put all labels back"));
  });
}

void PreviewLabels::change(const ChangeLabel &change) { m_model.history().edit(change, wordsFor(change)); }

QString PreviewLabels::wordsFor(const ChangeLabel &change) const {
  return QString::fromStdString(wordsForLabel(m_model.session().scene, change));
}

bool PreviewLabels::canUndo() const { return m_model.history().index() > m_stepsBefore; }

bool PreviewLabels::canRedo() const { return m_undone > 0 && m_model.history().redoText(); }

void PreviewLabels::undo() {
  if (!canUndo())
    return;
  m_model.history().undo();
  ++m_undone;
}

void PreviewLabels::redo() {
  if (!canRedo())
    return;
  m_model.history().redo();
  --m_undone;
}

} // namespace halfspace
