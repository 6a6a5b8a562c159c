// The scene as a picture, in a file and on the clipboard.
#pragma once

#include "app/panels/messages.h"
#include "widgets/picture/rgba_image.h"

#include <QObject>

#include <optional>

namespace halfspace {

class SceneView;
class SessionModel;
class Typesetter;
class WindowLook;

/// Draws what the 3D view shows, without handles, twice as fine as on the screen.
class PictureExport : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  PictureExport(const SessionModel &model, SceneView &scene, const WindowLook &look,
                const Typesetter &typesetter, Messages messages, QObject *parent = nullptr);

  /// Asks for a file and writes the picture to it.
  void askAndSave();
  /// Writes it as a PNG file; on failure says why and returns false.
  bool saveTo(const QString &file);
  void copy();

private:
  [[nodiscard]] std::optional<RgbaImage> draw();

  const SessionModel &m_model;
  SceneView &m_scene;
  const WindowLook &m_look;
  const Typesetter &m_typesetter;
  Messages m_messages;
};

} // namespace halfspace
