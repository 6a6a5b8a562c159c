// The formulas of all chapters.
#pragma once

#include <QObject>

namespace halfspace {

class FormulaDialog;
class SessionModel;
class Typesetter;
class WindowLook;

/// Opens them at the chapter of the lesson that is shown, and leads from a lesson's name to the lesson.
class FormulaPresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it; the dialog belongs to the window.
  FormulaPresenter(SessionModel &model, const WindowLook &look, const Typesetter &typesetter,
                   QWidget &window);

  void show();

private:
  /// Made when it is opened for the first time.
  void makeDialog();
  /// With the library as it is, which may be another one.
  void fill();

  SessionModel &m_model;
  const WindowLook &m_look;
  const Typesetter &m_typesetter;
  QWidget &m_window;
  FormulaDialog *m_dialog = nullptr; ///< the window's
};

} // namespace halfspace
