// The scene with what lies over it, and the line of words below.
#pragma once

#include "widgets/picture/theme.h"

#include <QWidget>

namespace halfspace {

class CaseLine;
class EntryBar;
class FlatView;
class NumberCard;
class SceneFrame;
class SceneView;
class SessionModel;
class Typesetter;

/// Puts a bar to type in, the 3D view, its card of numbers, its flat picture and the case line together; they
/// are its own.
class SceneColumn : public QWidget {
  Q_OBJECT
public:
  /// Model and typesetter must outlive it.
  SceneColumn(SessionModel &model, const Typesetter &typesetter, QWidget *parent = nullptr);

  /// Above the view, where something is typed.
  [[nodiscard]] EntryBar &bar() { return *m_bar; }
  [[nodiscard]] SceneView &view() { return *m_view; }
  [[nodiscard]] SceneFrame &frame() { return *m_frame; }
  [[nodiscard]] FlatView &flat() { return *m_flat; }
  [[nodiscard]] NumberCard &card() { return *m_card; }
  [[nodiscard]] CaseLine &caseLine() { return *m_caseLine; }

  /// `sizeScale`: how large type, lines and handles of the pictures are; `panels` is the theme of what lies
  /// over them, of that size already.
  void setLook(const Theme &theme, double sizeScale, const Theme &panels);

private:
  EntryBar *m_bar;
  SceneView *m_view;
  NumberCard *m_card;
  SceneFrame *m_frame; ///< around the view
  FlatView *m_flat;    ///< in the frame
  CaseLine *m_caseLine;
};

} // namespace halfspace
