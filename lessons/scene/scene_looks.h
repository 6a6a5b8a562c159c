// The looks of a scene's objects.
#pragma once

#include "lessons/scene/edit.h"

namespace halfspace {

/// The look of each entry's object, in the order of the entries. An object has the colour that its entry
/// says; else the first that is about a subject has that subject's, and each further one the hue that the
/// fewest have. So two objects about the same subject are alike only where a lesson wants them to be, and
/// even then their lines are not.
[[nodiscard]] std::vector<Look> looksOf(const Scene &scene);

/// Edits of a scene, and those after which the objects that were there have the colours that they had, where
/// others come or go. Edits that are refused are as they are, and so are those that would need very many
/// others. An entry that an edit replaces looks as that says.
[[nodiscard]] std::vector<Edit> keepingColors(const Scene &scene, std::vector<Edit> edits);

} // namespace halfspace
