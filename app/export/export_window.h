// The window in which a figure is looked at and saved or copied.
#pragma once

#include "app/export/figure_clipboard.h"
#include "app/export/preview_figure.h"
#include "app/export/window_figure.h"

#include <QDialog>
#include <QTimer>

#include <optional>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace halfspace {

class ExportForm;
class PreviewLabels;
class PreviewPane;
class SessionModel;

/// Choices beside a preview that follows them. All drawing goes on beside the event loop. What goes wrong is
/// said in the window.
class ExportWindow : public QDialog {
  Q_OBJECT
public:
  /// Model and figure must outlive it. `folder` is where the last figure went; empty: nowhere yet.
  ExportWindow(SessionModel &model, const WindowFigure &figure, const ExportChoices &choices, QString folder,
               QWidget *parent);

  [[nodiscard]] const ExportChoices &choices() const;
  [[nodiscard]] const QString &folder() const { return m_folder; }

  /// Writes the figure once it is drawn; how the file's name ends decides its format.
  void saveTo(const QString &file);
  /// Puts it on the clipboard once it is drawn.
  void copy();

  /// Not while the figure is being drawn that is to be saved or copied. A label that is held goes back first.
  void reject() override;
  void done(int result) override;

signals:
  void settled();   ///< choices and folder are to be kept
  void previewed(); ///< the preview shows what is chosen

private:
  void fill();
  void followLabels(SessionModel &model);
  [[nodiscard]] QBoxLayout *previewColumn();
  void takeChoices();
  void askForPreview();
  void takePreview(const Result<FigurePreview> &preview, bool isTransparent);
  /// Makes the file of what is chosen; it is written where its name is told.
  void askForFile(const QString &saveTo = {});
  void write(const Result<FigureFile> &figure, const QString &file);
  void askAndSave();
  void takeCopy(const Result<CopiedFigure> &figure);
  /// Neither saves nor copies until that ends.
  void setBusy(bool isBusy);
  void tell(const QString &sentence, bool isWrong = false);
  void complain(const QString &sentence) { tell(sentence, true); }

  const WindowFigure &m_figure;
  QString m_folder;
  ExportForm *m_form;
  PreviewPane *m_pane;
  PreviewLabels *m_labels; ///< in the pane
  QLabel *m_size;
  QLabel *m_message;
  QPushButton *m_save = nullptr;
  QPushButton *m_copy = nullptr;
  int m_chosen = 0;            ///< counts what has been chosen
  QTimer m_rest;               ///< nobody has chosen anything for a moment
  FigureWorkshop m_previews{}; ///< ended before the rest of this, as the next
  FigureWorkshop m_files{};
};

} // namespace halfspace
