// The plot of what it costs to find the nearest hit, against the number of triangles.
#pragma once

#include "widgets/cost_plot/measure_cost.h"
#include "widgets/picture/theme.h"

#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

namespace halfspace {

enum class CostQuantity : std::uint8_t { LookedAt, Time };

/// Two curves over decades in both directions, each with its name at its end.
class CostCurves : public QWidget {
  Q_OBJECT
public:
  explicit CostCurves(QWidget *parent = nullptr);

  /// In ascending order of their triangles; none: empty axes. That of the scene stands beside the curves.
  void setPoints(const std::vector<CostPoint> &points, const std::optional<CostPoint> &inScene);
  void setQuantity(CostQuantity quantity);
  void setTheme(const Theme &theme);

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  /// A number of triangles with what they cost.
  struct Dot {
    double triangles;
    double cost;
  };
  /// A part of an axis, by powers of ten.
  struct Decades {
    int low;
    int high;
  };
  struct Curve {
    std::vector<Dot> dots;
    std::optional<Dot> inScene;
    QString name;
    Subject subject;
    bool isAbove; ///< its name stands above its end
  };
  class Axes;

  [[nodiscard]] std::vector<Curve> curves() const;
  [[nodiscard]] Decades heights() const;
  [[nodiscard]] QString heightWords(int decade) const;
  [[nodiscard]] QString title() const;
  [[nodiscard]] Axes axes() const;
  void paintAxes(QPainter &painter, const Axes &axes) const;
  void paintCurve(QPainter &painter, const Axes &axes, const Curve &curve) const;
  /// With the pen and brush of its curve.
  void paintInScene(QPainter &painter, const Axes &axes, const Curve &curve) const;
  void paintName(QPainter &painter, const Axes &axes, const Curve &curve) const;

  std::vector<CostPoint> m_points;
  std::optional<CostPoint> m_inScene;
  CostQuantity m_quantity = CostQuantity::LookedAt;
  Theme m_theme;
};

} // namespace halfspace
