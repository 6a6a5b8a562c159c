// What could be meant, below the field in which it is typed.
#pragma once

#include <QFrame>

#include <vector>

class QLabel;
class QTreeWidget;

namespace halfspace {

/// What somebody could mean by what is typed so far.
struct Suggestion {
  QString text;
  QString detail{};   ///< what it is, said beside it: a kind, a shortcut; may be empty
  bool isLine = true; ///< Tab puts it into the field
};

/// A sentence and a list that lie over the window below the field, as long as there is one of them. The field
/// keeps the focus.
class SuggestionList : public QFrame {
  Q_OBJECT
public:
  /// Lies in the window of the field, which it belongs to.
  explicit SuggestionList(QWidget &field);

  /// Above the list; `isWrong`: what is wrong with what is typed. Empty: none.
  void say(const QString &sentence, bool isWrong);
  void setSuggestions(const std::vector<Suggestion> &suggestions);
  /// The row that is chosen; −1 for none.
  [[nodiscard]] int currentRow() const;
  void setCurrentRow(int row);
  /// To a row farther up or down; beyond the last none is chosen.
  void stepBy(int rows);
  [[nodiscard]] bool hasRows() const;

signals:
  void taken(int row); ///< by the mouse

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  void place();

  QWidget &m_field;
  QLabel *m_sentence;
  QTreeWidget *m_rows;
};

} // namespace halfspace
