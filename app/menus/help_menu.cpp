#include "app/menus/help_menu.h"

#include "app/menus/add_item.h"
#include "app/menus/help_dialog.h"

#include <QApplication>
#include <QMessageBox>

namespace halfspace {

HelpMenu::HelpMenu(QWidget &window, QWidget *parent) : QMenu(tr("&Help"), parent) {
  addItem(*this, tr("&Mouse and Keys"), QKeySequence::HelpContents, this,
          [&window] { HelpDialog(&window).exec(); });
  addItem(*this, tr("&About Halfspace"), {}, this, [&window] {
    QMessageBox::about(
        &window, tr("About Halfspace"),
        tr("<h3>Halfspace %1</h3><p>Drag planes, points, rays and triangles, and read the "
           "exact working live.</p><p>Formulas are set in Latin Modern Math (GUST Font License) and "
           "CMU Serif (SIL Open Font License).</p>")
            .arg(QApplication::applicationVersion()));
  });
}

} // namespace halfspace
