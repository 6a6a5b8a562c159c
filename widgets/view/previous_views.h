// The views that can be gone back to.
#pragma once

#include "widgets/picture/camera.h"

#include <QObject>

#include <optional>
#include <vector>

namespace halfspace {

/// What was seen before the view was turned, moved or chosen, step by step; at most the newest 50.
class PreviousViews : public QObject {
  Q_OBJECT
public:
  /// This view is about to be left.
  void remember(const Camera &camera);
  /// … by a click of the wheel: all clicks in a row are one change of the view.
  void rememberZoomed(const Camera &camera);
  void forget();

  [[nodiscard]] bool isEmpty() const { return m_views.empty(); }
  /// The newest, which is then no longer among them; nothing where there is none.
  [[nodiscard]] std::optional<Camera> takeLast();

signals:
  void changed();

private:
  std::vector<Camera> m_views; ///< the newest last
  bool m_isZooming = false;
};

} // namespace halfspace
