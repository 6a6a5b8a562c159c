// The figure that the window shows, for files.
#pragma once

#include "app/export/export_choices.h"
#include "app/figures/figure_maker.h"

namespace halfspace {

class FlatView;
class SceneView;
class SessionModel;

/// What a figure is of, and how it is to be.
struct FigureRequest {
  FigureSubject subject;
  FigureChoices choices;
};

/// Looks at the window's scene each time that it is asked.
class WindowFigure {
public:
  /// All must outlive it.
  WindowFigure(const SessionModel &model, SceneView &scene, const FlatView &flat);

  /// What is on the screen now, without the tools of the hand, as somebody wants it.
  [[nodiscard]] FigureRequest requestFor(const ExportChoices &choices) const;
  /// Whether there is a flat picture of it.
  [[nodiscard]] bool hasFlat() const;
  /// Of a file of it, without an ending.
  [[nodiscard]] QString name() const;

private:
  const SessionModel &m_model;
  SceneView &m_scene;
  const FlatView &m_flat;
};

} // namespace halfspace
