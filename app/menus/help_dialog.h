// What mouse and keys do, on one page.
#pragma once

#include <QDialog>

namespace halfspace {

/// Two columns beside each other where there is room, else one below the other; what is higher than the
/// window can be scrolled.
class HelpDialog : public QDialog {
  Q_OBJECT
public:
  explicit HelpDialog(QWidget *parent);
};

} // namespace halfspace
