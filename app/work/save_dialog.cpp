#include "app/work/save_dialog.h"

#include <QFileDialog>

namespace halfspace {

QString askWhereToSave(QWidget &window, const QString &title, const QString &filter, const QString &name,
                       const QString &suffix, const QString &folder) {
  QFileDialog dialog(&window, title, folder, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(name + "." + suffix);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace halfspace
