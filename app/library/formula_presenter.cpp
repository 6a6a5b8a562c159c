#include "app/library/formula_presenter.h"

#include "app/panels/window_look.h"
#include "widgets/lesson/formula_dialog.h"
#include "widgets/session_model.h"

namespace halfspace {

FormulaPresenter::FormulaPresenter(SessionModel &model, const WindowLook &look, const Typesetter &typesetter,
                                   QWidget &window)
    : QObject(&window), m_model(model), m_look(look), m_typesetter(typesetter), m_window(window) {
  connect(&model, &SessionModel::lessonChanged, this, [this] {
    if (m_dialog && m_dialog->isVisible())
      fill();
  });
  connect(&look, &WindowLook::changed, this, [this] {
    if (m_dialog)
      m_dialog->setTheme(m_look.panelTheme());
  });
}

void FormulaPresenter::show() {
  if (!m_dialog)
    makeDialog();
  fill();
  m_dialog->open(QString::fromStdString(m_model.lesson().chapter));
}

void FormulaPresenter::makeDialog() {
  m_dialog = new FormulaDialog(m_typesetter, &m_window);
  connect(m_dialog, &FormulaDialog::lessonWanted, this, [this](const QString &id) {
    m_model.openLesson(id.toStdString());
    m_window.activateWindow();
  });
  m_dialog->setTheme(m_look.panelTheme());
}

void FormulaPresenter::fill() { m_dialog->setChapters(formulasOf(m_model.library())); }

} // namespace halfspace
