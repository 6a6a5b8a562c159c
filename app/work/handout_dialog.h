// Asks what a handout is to have in it.
#pragma once

#include "app/handout_file.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QListWidget;

namespace halfspace {

/// Which steps of a lesson, on which paper, in how many columns, with answers or without. Without a step it
/// cannot be accepted.
class HandoutDialog : public QDialog {
  Q_OBJECT
public:
  /// `step` is the one that is shown now, counted from 0. It begins with the choices but for their steps, of
  /// which all are chosen.
  HandoutDialog(const Lesson &lesson, int step, const HandoutChoices &choices, QWidget *parent);

  [[nodiscard]] HandoutChoices choices() const;

private:
  /// Chooses all steps, or one alone.
  void choose(std::optional<int> only);

  HandoutChoices m_before;
  QListWidget *m_steps;
  QComboBox *m_paper;
  QComboBox *m_columns;
  QCheckBox *m_answers;
};

} // namespace halfspace
