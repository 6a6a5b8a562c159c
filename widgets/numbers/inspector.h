// Every number of the session: what is given, to be changed, and what comes out of it.
#pragma once

#include "widgets/numbers/coordinate_row.h"

#include <QScrollArea>

#include <memory>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace halfspace {

class NumberField;

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
  struct ResultRow {
    std::string id; ///< as ShownValue says
    MathLabel *value;
  };

  void buildGivenRows();
  void buildResultRows();
  void addGivenRow(QGridLayout &grid, const CoordinateId &id);
  void addResultRow(QVBoxLayout &column, const NamedValue &value);
  void applyInk();

  SessionModel &m_model;
  CoordinateEditor m_editor;
  const Typesetter &m_typesetter;
  Theme m_theme;
  bool m_resultsHidden = false;
  std::vector<std::unique_ptr<CoordinateRow>> m_given;
  std::vector<ResultRow> m_results;
  std::vector<MathLabel *> m_resultLabels;
  QVBoxLayout *m_layout = nullptr;
  QWidget *m_resultsBox = nullptr;
  QLabel *m_complaint = nullptr;
};

} // namespace halfspace
