// What holds of what is selected.
#pragma once

#include "widgets/session_model.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace halfspace {

class SceneSelection;

/// A button that asks what holds of the selected objects, and the answer in sentences, until objects or
/// numbers are others.
class DiscoveryBox : public QWidget {
  Q_OBJECT
public:
  /// Both must outlive it.
  DiscoveryBox(const SessionModel &model, const SceneSelection &selection, QWidget *parent = nullptr);

  /// Tells what holds of what is selected now.
  void discover();

private:
  void forget();

  const SessionModel &m_model;
  const SceneSelection &m_selection;
  QPushButton *m_button;
  QLabel *m_answer;
};

} // namespace halfspace
