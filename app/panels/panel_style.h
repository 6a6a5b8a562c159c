// The style of the panels' widgets.
#pragma once

#include <QProxyStyle>

class QStyleOptionDockWidget;

namespace halfspace {

/// Qt's Fusion at another size, with check boxes that are seen on any palette and titles of panels in the
/// panels' own type.
class PanelStyle : public QProxyStyle {
  Q_OBJECT

public:
  explicit PanelStyle(double scale);

  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption *option,
                                const QWidget *widget) const override;
  [[nodiscard]] int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                              QStyleHintReturn *returned) const override;
  void drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                   const QWidget *widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget) const override;

private:
  void paintDockTitle(QPainter &painter, const QStyleOptionDockWidget &dock, const QWidget &widget) const;

  double m_scale;
};

} // namespace halfspace
