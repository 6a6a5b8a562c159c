// The contents: all lessons, and what of each is done.
#pragma once

#include <QObject>

namespace halfspace {

class ContentsDrawer;
class LearnerProgress;
class SessionModel;

/// Fills the drawer when it opens, closes it when another lesson is shown, and opens the lesson that is
/// chosen there.
class ContentsPresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  ContentsPresenter(SessionModel &model, ContentsDrawer &drawer, const LearnerProgress &progress,
                    QObject *parent = nullptr);

  void show();

private:
  SessionModel &m_model;
  ContentsDrawer &m_drawer;
  const LearnerProgress &m_progress;
};

} // namespace halfspace
