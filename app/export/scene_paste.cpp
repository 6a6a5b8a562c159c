#include "app/export/scene_paste.h"

#include "app/export/figure_clipboard.h"
#include "app/open_session.h"
#include "app/work/session_files.h"
#include "widgets/session_model.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <QUrl>

namespace halfspace {
namespace {

/// The one file that was copied, where it is of those that are opened; empty for anything else.
QString sessionFileOn(const QMimeData &clipboard) {
  const QList<QUrl> urls = clipboard.urls();
  const QString file = urls.size() == 1 ? urls.front().toLocalFile() : QString();
  return namesSession(file.toStdString()) ? file : QString();
}

} // namespace

ScenePaste::ScenePaste(const SessionModel &model, SessionFiles &files, Messages messages, QObject *parent)
    : QObject(parent), m_model(model), m_files(files), m_messages(messages) {}

void ScenePaste::paste() {
  const QMimeData *clipboard = QApplication::clipboard()->mimeData();
  if (!clipboard)
    return;
  if (const QString file = sessionFileOn(*clipboard); !file.isEmpty()) {
    if (m_files.mayLeave())
      m_files.open(file);
    return;
  }
  const auto found = sessionOn(*clipboard);
  const bool isLines =
      clipboard->hasText() && !clipboard->text().trimmed().startsWith('{'); // as a session does
  if (!found && isExplore(m_model) && isLines)
    return emit textPasted(clipboard->text());
  if (!found)
    return m_messages.say(QString::fromStdString(found.problem().text()));
  if (m_files.mayLeave())
    m_files.startWith(found->session);
}

} // namespace halfspace
