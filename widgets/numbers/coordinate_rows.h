// The fields of several coordinates, wherever they are laid out.
#pragma once

#include "widgets/numbers/coordinate_row.h"

#include <memory>

namespace halfspace {

class CoordinateRows : public QObject {
  Q_OBJECT
public:
  /// Model and typesetter must outlive it.
  CoordinateRows(SessionModel &model, const Typesetter &typesetter);

  /// Rows for these, in the place of those that were there. Whoever asks for them lays out their widgets.
  const std::vector<std::unique_ptr<CoordinateRow>> &make(const std::vector<CoordinateId> &ids);
  /// Whether the rows are made for these coordinates as they are now: then they may stay, as a field may be
  /// in use.
  [[nodiscard]] bool areMadeFor(const std::vector<CoordinateId> &ids) const;
  /// Writes the numbers as they are in the session.
  void showNumbers();
  void setTheme(const Theme &theme);

  /// What entering the number that is typed would change; nothing where none is.
  [[nodiscard]] std::optional<ChangeObject> typed() const;
  /// Ends a scrub, and enters the numbers that are typed and not entered yet. Why one is refused; else empty.
  [[nodiscard]] QString enterTyped();
  /// Takes back what is typed and refused.
  void dropTyped();
  /// The field of a coordinate: `E.n`, `Q`; axis 0, 1, 2. Null when there is none.
  [[nodiscard]] NumberField *field(const std::string &coordinateName, int axis) const;

signals:
  void typing();                         ///< what is typed has changed, and is not entered yet
  void refused(const QString &sentence); ///< why a typed text is not taken; empty once it is mended

private:
  SessionModel &m_model;
  CoordinateEditor m_editor;
  const Typesetter &m_typesetter;
  std::vector<std::unique_ptr<CoordinateRow>> m_rows;
};

} // namespace halfspace
