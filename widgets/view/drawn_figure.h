// What a view draws of the session: the figure of its step, as it comes, goes and glides.
#pragma once

#include "widgets/picture/scene_content.h"
#include "widgets/session_model.h"
#include "widgets/view/extent_glide.h"
#include "widgets/view/mark_fade.h"

namespace halfspace {

/// Follows the outcome of a session. How far others are drawn does not change during a gesture, and
/// afterwards they glide to where they must; the marks that another step adds fade in. `moving` says each
/// time whether that takes its time, else it is done at once.
class DrawnFigure : public QObject {
  Q_OBJECT

public:
  explicit DrawnFigure(const SessionModel &model);

  /// Nothing of what is drawn glides into the next lesson.
  void takeLesson();
  void takeOutcome(bool moving);
  /// A gesture has begun or ended.
  void takeGesture(bool moving);
  /// All that fades or glides is there.
  void arrive();

  /// The marks that stand out, as those that are hovered here or in a line.
  void setHighlighted(const std::set<std::string> &markIds);
  [[nodiscard]] const std::set<std::string> &highlighted() const { return m_highlighted; }
  /// What is drawn of all that there is.
  void setShownParts(const ShownParts &shown);
  [[nodiscard]] const ShownParts &shownParts() const { return m_parts; }
  /// Hides the numbers in labels, while a question asks for them.
  void setNumbersHidden(bool hidden);
  [[nodiscard]] bool areNumbersHidden() const { return m_areNumbersHidden; }

  /// What would come of a tool in the hand, in units of the stage: drawn besides, but in no other picture.
  void setGhost(Figure ghost);

  /// On the stage, with all where it must be.
  [[nodiscard]] const Figure &figure() const { return m_figure; }
  /// … as it is drawn at this moment.
  [[nodiscard]] Figure drawnFigure() const { return m_extents.drawn(m_figure); }
  /// What a picture shows, with all where it must be.
  [[nodiscard]] SceneContent pictureContent() const;
  /// … as it is drawn at this moment, with what stands out.
  [[nodiscard]] SceneContent drawnContent() const;

signals:
  void changed(); ///< others stand out, numbers come or go, or the ghost is another one
  void moved();   ///< what is drawn glides or fades

private:
  void holdExtents();
  /// After an edit that is no gesture others glide to where they must.
  void glideTo(const Extents &next, bool moving);

  const SessionModel &m_model;
  Stage m_stage; ///< the model's, that the figure is on
  Figure m_figure;
  Figure m_ghost;
  std::set<std::string> m_highlighted;
  ShownParts m_parts;
  bool m_areNumbersHidden = false;
  MarkFade m_fade;
  ExtentGlide m_extents;
};

} // namespace halfspace
