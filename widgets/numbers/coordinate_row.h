// The letter of a coordinate with the fields of its numbers.
#pragma once

#include "widgets/numbers/coordinate_editor.h"
#include "widgets/picture/theme.h"
#include "widgets/text/math_label.h"

class QSlider;

namespace halfspace {

class NumberField;

/// Makes the widgets of one coordinate of the scene and writes what is typed, stepped and scrubbed in them
/// into the session. They have no parent until they are laid out, and belong to the layout's widget then.
class CoordinateRow : public QObject {
  Q_OBJECT
public:
  /// Model, editor and typesetter must outlive it; the coordinate is there.
  CoordinateRow(SessionModel &model, CoordinateEditor &editor, const Typesetter &typesetter, CoordinateId id);

  /// As in `E.n`, `Q`.
  [[nodiscard]] const std::string &name() const { return m_name; }
  [[nodiscard]] MathLabel *letter() const { return m_label; }
  /// Three, or one for a single number.
  [[nodiscard]] const std::vector<NumberField *> &fields() const { return m_fields; }
  /// Of a number within bounds; null for all others.
  [[nodiscard]] QSlider *slider() const { return m_slider; }

  /// Whether the row is made for this coordinate as it is now.
  [[nodiscard]] bool isMadeFor(const CoordinateId &id) const;
  /// Writes the numbers as they are in the session.
  void showNumbers();
  /// The letter is as its mark in the figure.
  void setTheme(const Theme &theme);

  /// What entering the number that is typed would change; nothing where none is.
  [[nodiscard]] std::optional<ChangeObject> typed() const;
  /// Ends a scrub, and enters what is typed and not entered yet. Why it is refused; else empty.
  [[nodiscard]] QString enterTyped();
  /// Takes back what is typed and refused.
  void dropTyped();

signals:
  void typing();                         ///< what is typed has changed, and is not entered yet
  void refused(const QString &sentence); ///< why a typed text is not taken; empty once it is mended

private:
  void addFields();
  void connectField(NumberField &field, const CoordinateNumber &number);
  void addSlider();
  void showOnSlider();
  [[nodiscard]] const Object &object() const;
  [[nodiscard]] const Symbol &currentLetter(const CoordinateId &id) const;

  SessionModel &m_model;
  CoordinateEditor &m_editor;
  CoordinateId m_id;
  Symbol m_letter;
  std::string m_name;
  MathLabel *m_label;
  std::vector<NumberField *> m_fields;
  QSlider *m_slider = nullptr;
  int m_sliderStart = 0; ///< where it stood when it was taken hold of
};

} // namespace halfspace
