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

/// Draws what the 3D view shows, without handles, twice as fine as on the screen. The pictures carry the
/// session, so that they can be opened again.
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
  /// The PNG file of a picture, with the session in it; nothing where it cannot be made, which is said.
  [[nodiscard]] std::optional<std::string> fileOf(const RgbaImage &picture);

  const SessionModel &m_model;
  SceneView &m_scene;
  const WindowLook &m_look;
  const Typesetter &m_typesetter;
  Messages m_messages;
};

} // namespace halfspace
