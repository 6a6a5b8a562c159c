// The dialog that asks where to save.
#pragma once

#include <QString>

class QWidget;

namespace halfspace {

/// The file that the user chooses, with the suffix where none is typed; empty: none is chosen. `name` is
/// suggested.
[[nodiscard]] QString askWhereToSave(QWidget &window, const QString &title, const QString &filter,
                                     const QString &name, const QString &suffix);

} // namespace halfspace
