#include "app/panels/panel_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace halfspace {
namespace {

constexpr double cornerRadius = 2;
/// Before the title of a panel, in pixels at a scale of 1.
constexpr double titleIndent = 12;
/// The tick's pen, in heights of the box.
constexpr double tickWidth = 0.14;

/// A box in the ink of the text, which every theme makes readable; Fusion's own is a shade of the background.
void paintCheckBox(QPainter &painter, const QStyleOption &option) {
  const QPalette::ColorGroup group =
      option.state & QStyle::State_Enabled ? QPalette::Active : QPalette::Disabled;
  const QColor ink = option.palette.color(group, QPalette::WindowText);
  const QRectF box = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ink, 1));
  painter.setBrush(option.palette.color(QPalette::Base));
  painter.drawRoundedRect(box, cornerRadius, cornerRadius);
  if (option.state & QStyle::State_On) {
    const auto at = [&](double x, double y) {
      return box.topLeft() + QPointF(x * box.width(), y * box.height());
    };
    painter.setPen(QPen(ink, tickWidth * box.height(), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF({at(0.24, 0.54), at(0.43, 0.74), at(0.78, 0.28)}));
  }
  painter.restore();
}

} // namespace

PanelStyle::PanelStyle(double scale) : QProxyStyle(QStyleFactory::create("Fusion")), m_scale(scale) {}

int PanelStyle::pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const {
  const int usual = QProxyStyle::pixelMetric(metric, option, widget);
  return usual > 1 ? qRound(usual * m_scale) : usual; // hairlines stay hairlines
}

int PanelStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                          QStyleHintReturn *returned) const {
  // A bright shadow under disabled text makes it hard to read on dark panels.
  return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, returned);
}

void PanelStyle::drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                             const QWidget *widget) const {
  const auto *dock = qstyleoption_cast<const QStyleOptionDockWidget *>(option);
  if (element == CE_DockWidgetTitle && dock && widget)
    paintDockTitle(*painter, *dock, *widget);
  else
    QProxyStyle::drawControl(element, option, painter, widget);
}

void PanelStyle::paintDockTitle(QPainter &painter, const QStyleOptionDockWidget &dock,
                                const QWidget &widget) const {
  const QRect room = subElementRect(SE_DockWidgetTitleBarText, &dock, &widget)
                         .adjusted(qRound(titleIndent * m_scale), 0, 0, 0);
  painter.save();
  painter.setFont(widget.font()); // Qt leaves the painter with the font that the program began with
  painter.setPen(dock.palette.color(QPalette::PlaceholderText));
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   widget.fontMetrics().elidedText(dock.title, Qt::ElideRight, room.width()));
  painter.restore();
}

void PanelStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                               const QWidget *widget) const {
  if (element == PE_IndicatorCheckBox)
    paintCheckBox(*painter, *option);
  else
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

} // namespace halfspace
