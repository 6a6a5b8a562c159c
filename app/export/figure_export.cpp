#include "app/export/figure_export.h"

#include "app/export/export_window.h"
#include "app/panels/scene_column.h"
#include "app/settings.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>

namespace halfspace {

FigureExport::FigureExport(SessionModel &model, SceneColumn &scene, Messages messages, QObject *parent)
    : QObject(parent), m_model(model), m_figure(model, scene.view(), scene.flat()), m_messages(messages) {}

void FigureExport::open() {
  if (m_window)
    return m_window->activateWindow();
  m_window = new ExportWindow(m_model, m_figure, m_choices, m_folder, &m_messages.window());
  m_window->setAttribute(Qt::WA_DeleteOnClose);
  connect(m_window, &ExportWindow::settled, this, [this] { takeFrom(*m_window); });
  m_window->open();
}

void FigureExport::copy() {
  FigureStudio studio;
  const FigureRequest request = m_figure.requestFor(m_choices);
  const auto figure = copiedFigure(studio.maker, request.subject, request.choices);
  if (!figure)
    return m_messages.complain(QString::fromStdString(figure.problem().sentence));
  QApplication::clipboard()->setMimeData(toMimeData(*figure).release());
  m_messages.say(tr("Picture copied."));
}

void FigureExport::take(const Settings &settings) {
  m_choices = settings.figure;
  m_folder = settings.figureFolder;
}

void FigureExport::put(Settings &settings) const {
  settings.figure = m_choices;
  settings.figureFolder = m_folder;
}

void FigureExport::takeFrom(const ExportWindow &window) {
  if (window.choices() == m_choices && window.folder() == m_folder)
    return;
  m_choices = window.choices();
  m_folder = window.folder();
  emit chosen();
}

} // namespace halfspace
