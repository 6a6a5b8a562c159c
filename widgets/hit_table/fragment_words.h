// What a table of fragments says in words.
#pragma once

#include "widgets/hit_table/fragment_rows.h"

#include <QString>

namespace halfspace {

/// The heads of the columns of words.
[[nodiscard]] QString headOfNames();
[[nodiscard]] QString headOfVerdicts();

[[nodiscard]] QString verdictOf(const FragmentRow &row, LiveValues values);
/// The same where there is little room.
[[nodiscard]] QString shortVerdictOf(const FragmentRow &row, LiveValues values);

/// A row as it is read aloud.
[[nodiscard]] QString spokenRow(const FragmentRow &row, LiveValues values);
/// What the last line says of fragments without a row; empty where all have one.
[[nodiscard]] QString leftOutWords(const FragmentRows &shown);

} // namespace halfspace
