// The language that this program addresses its user in.
#pragma once

class QCoreApplication;

namespace halfspace {

/// Sets the language for sentences and numbers, before the first of them: English, or what the environment
/// asks for. `HALFSPACE_LANGUAGE=pseudo` is for those who look for texts that cannot be translated. Numbers
/// have a decimal comma, typed ones too, where the user's locale has it.
void setUserLanguage();

/// The same for the texts of windows. Requires setUserLanguage.
void translateWindows(QCoreApplication &application);

} // namespace halfspace
