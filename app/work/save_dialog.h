// The dialog that asks where to save.
#pragma once

#include <QString>

class QWidget;

namespace halfspace {

/// The file that the user chooses, with the suffix where none is typed; empty: none is chosen. `name` is
/// suggested, in the folder where one is given that is there. Replacing a file is asked about.
[[nodiscard]] QString askWhereToSave(QWidget &window, const QString &title, const QString &filter,
                                     const QString &name, const QString &suffix, const QString &folder = {});

} // namespace halfspace
