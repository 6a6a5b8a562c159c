// Every number of the session: what is given, to be changed, and what comes out of it.
#pragma once

#include "widgets/numbers/coordinate_rows.h"
#include "widgets/when_seen.h"

#include <QScrollArea>

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

  /// Writes the rows from the session and what it comes to: at once where they are seen, else once they are.
  void showSession();
  void setTheme(const Theme &theme);
  /// Hides what comes out, while a question asks for it.
  void setResultsHidden(bool hidden);

  [[nodiscard]] QSize sizeHint() const override;

  /// The fields of what is given; none before they were seen for the first time.
  [[nodiscard]] CoordinateRows &given() { return m_given; }

private:
  struct ResultRow {
    std::string id; ///< as ShownValue says
    MathLabel *value;
  };

  void writeRows();
  void writeResults();
  void buildGivenRows(const std::vector<CoordinateId> &ids);
  void buildResultRows();
  static void addGivenRow(QGridLayout &grid, const CoordinateRow &row);
  void addResultRow(QVBoxLayout &column, const NamedValue &value);
  void applyInk();

  SessionModel &m_model;
  const Typesetter &m_typesetter;
  CoordinateRows m_given;
  Theme m_theme;
  bool m_resultsHidden = false;
  std::vector<ResultRow> m_results;
  std::vector<MathLabel *> m_resultLabels;
  QVBoxLayout *m_layout = nullptr;
  QWidget *m_resultsBox = nullptr;
  QLabel *m_complaint = nullptr;
  WhenSeen m_rows{*this, [this] { writeRows(); }};
};

} // namespace halfspace
