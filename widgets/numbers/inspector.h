// Every number of the session: what is given, to be changed, and what comes out of it.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/working/coordinate_editor.h"

#include <QScrollArea>

class QGridLayout;
class QLabel;
class QSlider;
class QVBoxLayout;

namespace halfspace {

class MathLabel;
class NumberField;
class Typesetter;

class Inspector : public QScrollArea {
  Q_OBJECT

public:
  Inspector(SessionModel &model, const Typesetter &typesetter, QWidget *parent = nullptr);
  ~Inspector() override;

  /// Writes the rows from the session and what it comes to.
  void showSession();
  void setTheme(const Theme &theme);
  /// Hides what comes out, while a question asks for it.
  void setResultsHidden(bool hidden);

  /// Ends a scrub, and enters the numbers that are typed and not entered yet. Why one is refused; else empty.
  [[nodiscard]] QString enterTyped();
  /// Takes back what is typed and refused.
  void dropTyped();

  /// The field of a coordinate: `E.n`, `Q`; axis 0, 1, 2. Null when there is none.
  [[nodiscard]] NumberField *field(const std::string &coordinateName, int axis) const;

private:
  struct GivenRow {
    CoordinateId id;
    Symbol letter;
    std::string name;
    std::vector<NumberField *> fields; ///< three, or one
    QSlider *slider = nullptr;         ///< of a number within bounds
  };
  struct ResultRow {
    std::string id; ///< as ShownValue says
    MathLabel *value;
  };

  void buildGivenRows();
  void buildResultRows();
  [[nodiscard]] const Symbol &letterOf(const CoordinateId &id) const;
  /// Whether the row is made for this coordinate as it is now.
  [[nodiscard]] bool isShownIn(const GivenRow &row, const CoordinateId &id) const;
  [[nodiscard]] QSlider *addSlider(QGridLayout &grid, int row, const CoordinateId &id);
  void showOnSlider(QSlider &slider, const CoordinateId &id);
  void addGivenRow(QGridLayout &grid, const CoordinateId &id);
  void addResultRow(QVBoxLayout &column, const NamedValue &value);
  void connectField(NumberField &field, const CoordinateNumber &number);
  void applyInk();

  SessionModel &m_model;
  CoordinateEditor m_editor;
  const Typesetter &m_typesetter;
  Theme m_theme;
  bool m_resultsHidden = false;
  std::vector<GivenRow> m_given;
  std::vector<ResultRow> m_results;
  int m_sliderStart = 0; ///< where the slider stood that is held
  std::vector<MathLabel *> m_givenLabels;
  std::vector<MathLabel *> m_resultLabels;
  QVBoxLayout *m_layout = nullptr;
  QWidget *m_resultsBox = nullptr;
  QLabel *m_complaint = nullptr;
};

} // namespace halfspace
