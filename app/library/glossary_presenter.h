// The glossary of all lessons.
#pragma once

#include "lessons/lesson/glossary.h"

#include <QObject>

#include <memory>

class QPixmap;
class QSize;
class QUrl;

namespace halfspace {

class GlossaryDialog;
class OffscreenPainter;
class SceneView;
class SessionModel;
class StepTurner;
class Typesetter;
class WindowLook;

/// Opens it, also where a term among the words of a lesson is clicked, and leads from a term to its step.
class GlossaryPresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  GlossaryPresenter(SessionModel &model, StepTurner &turner, SceneView &scene, const WindowLook &look,
                    const Typesetter &typesetter, QObject *parent = nullptr);
  ~GlossaryPresenter() override;

  void show();
  /// At the term of an address of TermLinks.
  Q_INVOKABLE void showTermAt(const QUrl &address);

private:
  /// The dialog, which is made when it is opened for the first time, with the terms of all lessons.
  GlossaryDialog &filled();
  void makeDialog();
  void fillIfOpen();
  void fill();
  [[nodiscard]] QPixmap figureOf(const GlossaryEntry &entry, const QSize &room);
  void goTo(const GlossaryEntry &entry);

  SessionModel &m_model;
  StepTurner &m_turner;
  SceneView &m_scene;
  const WindowLook &m_look;
  const Typesetter &m_typesetter;
  Glossary m_glossary;                         ///< of the dialog's terms; filled anew when it opens
  GlossaryDialog *m_dialog = nullptr;          ///< the window's
  std::unique_ptr<OffscreenPainter> m_painter; ///< while the dialog is open
};

} // namespace halfspace
