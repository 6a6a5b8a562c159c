// The camera glides from one view to another.
#pragma once

#include "widgets/picture/camera.h"

#include <QVariantAnimation>

namespace halfspace {

/// Takes a camera from where it is to another view over a moment.
class CameraGlide : public QObject {
  Q_OBJECT

public:
  /// How long it takes, in milliseconds.
  static constexpr int glideTime = 350;

  CameraGlide();

  void start(const Camera &from, const Camera &to);
  /// The camera stays where it is now.
  void stop() { m_animation.stop(); }
  /// A camera that is on its way is there.
  void arrive();

signals:
  void moved(const halfspace::Camera &camera);

private:
  Camera m_from;
  Camera m_to;
  QVariantAnimation m_animation;
};

} // namespace halfspace
