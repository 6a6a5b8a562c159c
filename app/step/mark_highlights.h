// What stands out in the picture, in the flat picture and in the lines at once.
#pragma once

#include <QObject>

#include <set>
#include <string>

namespace halfspace {

class DrawnFigure;
class FlatView;
class SceneView;
class StepWorking;

/// Highlights the mark that the pointer is on, wherever it is, the marks of a fragment that it is on, and
/// those that the traced number came from, and what is selected.
class MarkHighlights : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  MarkHighlights(SceneView &scene, FlatView &flat, StepWorking &working);

  /// The pointer is on a fragment with these marks; none: on no fragment.
  void setFragment(const std::set<std::string> &marks);
  /// These marks are selected, as long as no others are.
  void setSelected(const std::set<std::string> &marks);

signals:
  void markHovered(const QString &markId); ///< before it stands out; empty: none

private:
  void hover(const QString &markId);
  void show();

  DrawnFigure &m_drawn;
  FlatView &m_flat;
  StepWorking &m_working;
  QString m_mark; ///< that the pointer is on
  std::set<std::string> m_fragment;
  std::set<std::string> m_selected;
};

} // namespace halfspace
