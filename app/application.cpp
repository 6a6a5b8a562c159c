#include "app/application.h"

#include "app/last_words.h"
#include "app/standard_streams.h"

#include <utility>

namespace halfspace {

bool Application::notify(QObject *receiver, QEvent *event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception &exception) {
    endAfter(exception);
    return false;
  }
}

void Application::endAfter(const std::exception &exception) {
  if (std::exchange(m_isEnding, true))
    return; // the loop has a few events left
  printError(lastWordsOn(exception));
  try {
    if (m_lastDeed)
      m_lastDeed();
  } catch (const std::exception &another) {
    printError(lastWordsOn(another));
  }
  QApplication::exit(exitRefused);
}

} // namespace halfspace
