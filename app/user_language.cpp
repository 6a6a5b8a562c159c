#include "app/user_language.h"

#include "lessons/language.h"
#include "lessons/pseudo_language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include <cstdlib>
#include <string_view>

namespace halfspace {
namespace {

/// Windows in the language of all other sentences.
class LanguageTranslator : public QTranslator {
public:
  using QTranslator::QTranslator;

  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char * /*context*/, const char *english,
                                  const char * /*disambiguation*/, int /*count*/) const override {
    return QString::fromStdString(halfspace::language().catalogue(english));
  }
};

/// What the user's own keyboard and numbers have.
char usualDecimalMark() { return QString(QLocale::system().decimalPoint()) == "," ? ',' : '.'; }

} // namespace

void setUserLanguage() {
  const char *asked = std::getenv("HALFSPACE_LANGUAGE");
  setLanguage(asked && std::string_view(asked) == "pseudo" ? pseudoLanguage()
                                                           : Language{{}, usualDecimalMark()});
}

void translateWindows(QCoreApplication &application) {
  if (language().catalogue)
    QCoreApplication::installTranslator(new LanguageTranslator(&application));
}

} // namespace halfspace
