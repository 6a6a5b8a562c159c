#include "app/panels/theme_title.h"

#include <QCoreApplication>
#include <QMap>

namespace halfspace {
namespace {

struct ThemeTitle {
  Q_DECLARE_TR_FUNCTIONS(halfspace::ThemeTitle)
};

} // namespace

QString themeTitle(const QString &name) {
  const QMap<QString, QString> titles{{"light", ThemeTitle::tr("Light")},
                                      {"dark", ThemeTitle::tr("Dark")},
                                      {"print", ThemeTitle::tr("Print")},
                                      {"projector", ThemeTitle::tr("Projector")}};
  return titles.value(name);
}

} // namespace halfspace
