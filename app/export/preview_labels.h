// The labels of a preview under the hand.
#pragma once

#include "app/export/preview_figure.h"
#include "lessons/scene/history.h"
#include "widgets/picture/hand/label_hand.h"

#include <QObject>
#include <QPointF>

class QMenu;

namespace halfspace {

class PreviewPane;
class SessionModel;

/// Lets labels be dragged, hidden and put back in a preview; each is a step in the scene's history, and is
/// kept with the scene.
class PreviewLabels : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  PreviewLabels(SessionModel &model, PreviewPane &pane, QObject *parent);

  /// What the pane shows now; nothing: it has no labels that can be moved.
  void setShapes(std::optional<PreviewShapes> shapes) { m_shapes = std::move(shapes); }
  /// Fills a menu with all labels of the preview, the hidden ones too.
  void fillMenu(QMenu &menu);
  /// Takes back what was done here last; what was done before stays.
  void undo();
  /// Does again what was taken back here.
  void redo();
  /// A label that is held stays where it is.
  void letGo();
  /// A label that is held goes back to where it was taken; false where none is.
  bool putBackHeld();

private:
  /// The pixel of the shapes' view at a part of the way through the page.
  [[nodiscard]] glm::dvec2 pixelAt(QPointF part) const;
  /// The mark whose label lies there; empty for none.
  [[nodiscard]] std::string markAt(QPointF part) const;
  void hover(QPointF part);
  void take(QPointF part);
  void move(QPointF part);
  void openMenu(QPointF part, const QPoint &at);
  void change(const ChangeLabel &change);
  [[nodiscard]] QString wordsFor(const ChangeLabel &change) const;
  void addPutAllBack(QMenu &menu);
  [[nodiscard]] bool canUndo() const;
  [[nodiscard]] bool canRedo() const;
  void addUndoAndRedo(QMenu &menu);

  SessionModel &m_model;
  PreviewPane &m_pane;
  std::optional<PreviewShapes> m_shapes;
  std::string m_chosen; ///< the mark of the label that was taken last; empty: none
  std::optional<HeldLabel> m_held;
  GestureToken m_gesture = GestureToken::Nobodys;
  int m_stepsBefore; ///< in the history
  int m_undone = 0;  ///< steps that were taken back here
};

} // namespace halfspace
