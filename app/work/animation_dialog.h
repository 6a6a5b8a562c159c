// The dialog that asks how a scene is to be shown in motion.
#pragma once

#include "widgets/animation/animation_format.h"
#include "widgets/animation/motion.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace halfspace {

/// What somebody wants of an animation.
struct AnimationChoices {
  const MotionKind *motion = nullptr;      ///< never null
  const AnimationFormat *format = nullptr; ///< likewise
  PixelSize size{960, 600};
  double seconds = 1;
  int framesPerSecond = 25;
  bool isTransparent = false;
};

/// Keeps what was chosen for the next time.
class AnimationDialog : public QDialog {
  Q_OBJECT
public:
  explicit AnimationDialog(QWidget *parent);

  /// Offers the motions that a scene has. Where that one is among them that was chosen last, it stays chosen.
  void setScene(const AnimatedScene &scene);
  /// Requires a scene that has a motion.
  [[nodiscard]] AnimationChoices choices() const;

private:
  /// A motion that the scene has, and how long it takes by itself.
  struct Offer {
    const MotionKind *motion;
    double seconds;
  };

  void takeMotion();
  void takeFormat();
  [[nodiscard]] const AnimationFormat &format() const;

  std::vector<Offer> m_offers;
  QComboBox *m_motion;
  QComboBox *m_format;
  QSpinBox *m_width;
  QSpinBox *m_height;
  QDoubleSpinBox *m_seconds;
  QComboBox *m_framesPerSecond;
  QCheckBox *m_transparent;
};

} // namespace halfspace
