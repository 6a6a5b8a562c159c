// What can be made of what is selected.
#pragma once

#include "lessons/fitting/fits.h"
#include "widgets/session_model.h"

#include <QWidget>

class QLabel;

namespace halfspace {

class EntryEdits;
class FlowLayout;
class SceneSelection;

/// A button for each entry that fits the selection, and for each that needs one more object: a click adds the
/// one; for the other the next object that is selected is taken, if it fits. While the pointer is on a button
/// its picture can be shown as it would be.
class FitsBox : public QWidget {
  Q_OBJECT
public:
  /// All must outlive it.
  FitsBox(SessionModel &model, SceneSelection &selection, EntryEdits &edits, QWidget *parent = nullptr);

signals:
  /// What the entry under the pointer would look like, in units of the stage; empty: the pointer is on none.
  void previewed(const halfspace::Figure &ghost);

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;
  void hideEvent(QHideEvent *event) override;

private:
  /// What the fits depend on.
  struct Asked {
    std::vector<std::string> ids{};          ///< the selection
    std::shared_ptr<const ScenePlan> plan{}; ///< of the scene
    QString missing{};                       ///< why there are none for what is not there
    bool operator==(const Asked &) const = default;
  };

  void takeSelection();
  void showFits();
  void addButton(const Fit &fit);
  void take(const Fit &fit);
  void add(const Entry &entry);
  /// What the object makes of the fit that wanted one, which was selected last; nothing where it does not
  /// fit.
  [[nodiscard]] std::optional<Entry> completed(const Fit &wanting) const;
  /// Why one of these objects is not there now; empty where all are.
  [[nodiscard]] QString missingOf(const std::vector<std::string> &ids) const;
  /// Of nothing: where something is shown, it goes.
  void preview(const Figure &ghost);
  [[nodiscard]] Figure ghostOf(const Entry &entry) const;

  SessionModel &m_model;
  SceneSelection &m_selection;
  EntryEdits &m_edits;
  QLabel *m_heading;
  QWidget *m_buttons = nullptr; ///< made anew for each selection
  Asked m_asked;                ///< when they were found
  std::vector<Fit> m_fits;      ///< in the order of the buttons
  std::optional<Fit> m_wanting; ///< that somebody has chosen, and that lacks an object
  QPoint m_pointer;             ///< where it was when they were made
  bool m_isPreviewing = false;
  const QObject *m_previewed = nullptr; ///< the button that was pointed at last
};

} // namespace halfspace
