// The style of the panels' widgets.
#pragma once

#include <QProxyStyle>

namespace halfspace {

/// Qt's Fusion at another size, with check boxes that are seen on any palette.
class PanelStyle : public QProxyStyle {
  Q_OBJECT

public:
  explicit PanelStyle(double scale);

  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption *option,
                                const QWidget *widget) const override;
  [[nodiscard]] int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                              QStyleHintReturn *returned) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget) const override;

private:
  double m_scale;
};

} // namespace halfspace
