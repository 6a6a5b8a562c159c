// How far others are drawn does not change while something is dragged; afterwards they glide to where they
// must.
#pragma once

#include "lessons/figure/extents.h"

#include <QVariantAnimation>

namespace halfspace {

/// Holds the extents of marks during a gesture.
class ExtentGlide : public QObject {
  Q_OBJECT

public:
  /// How long the glide takes, in milliseconds.
  static constexpr int glideTime = 200;

  explicit ExtentGlide(QObject *parent = nullptr);

  /// From now on these marks are drawn so far.
  void hold(Extents extents);
  [[nodiscard]] bool isHolding() const { return m_isHolding; }
  /// But no longer this one, which is what is dragged.
  void leave(const std::string &mark) { m_held.erase(mark); }
  /// They go to where they must: over a moment with `moving`, else at once.
  void release(bool moving);
  /// Those that are on their way are there.
  void arrive();

  /// A figure as it is drawn now.
  [[nodiscard]] Figure drawn(Figure figure) const;

signals:
  void changed(); ///< of how far marks are drawn, while they glide and when they arrive

private:
  Extents m_held;
  bool m_isHolding = false;
  double m_part = 0; ///< of the glide
  QVariantAnimation m_animation;
};

} // namespace halfspace
