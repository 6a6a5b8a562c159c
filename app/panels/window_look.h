// How the window looks: its theme, the size of type, lines and handles, and whether pictures move.
#pragma once

#include "app/panels/size_scale.h"
#include "app/settings.h"
#include "widgets/picture/theme.h"

#include <QAction>
#include <QObject>

class QWidget;

namespace halfspace {

/// What the user has chosen of this, and what is in force.
class WindowLook : public QObject {
  Q_OBJECT
public:
  /// The screen of the window says what size is usual.
  explicit WindowLook(QWidget &window);

  /// Of the pictures, whose size is told apart from it.
  [[nodiscard]] const Theme &theme() const { return m_theme; }
  /// Of all other parts, with text of the size in force.
  [[nodiscard]] Theme panelTheme() const;
  /// A theme that there is not changes nothing.
  void setThemeNamed(const QString &name);
  /// As setThemeNamed, by the user.
  void chooseTheme(const QString &name);

  /// The scale in force: together with a theme of large type it stays within the bounds of size_scale.h.
  [[nodiscard]] double sizeScale() const;
  /// How large type, lines and handles are, within the same bounds.
  void setSizeScale(double scale);
  /// So many steps larger, or smaller, by the user.
  void changeSizeBy(int steps);
  /// What suits the screen, by the user.
  void chooseUsualSize();
  [[nodiscard]] bool canGrow() const;
  [[nodiscard]] bool canShrink() const;

  /// Checked where the camera glides and flights go on by themselves.
  [[nodiscard]] QAction &motion() { return m_motion; }

  void take(const Settings &settings);
  /// All but the motion, which is put down when the window closes.
  void putTheme(Settings &settings) const;

signals:
  void changed();
  void chosen(); ///< by the user, after changed

private:
  QWidget &m_window;
  Theme m_theme;
  double m_sizeScale = smallestSizeScale; ///< as it was chosen
  QAction m_motion;
};

} // namespace halfspace
