#include "app/work/job_progress.h"

#include <utility>

namespace halfspace {
namespace {

/// What takes longer, in milliseconds, shows a bar.
constexpr int longestSilence = 400;
/// The bar's steps.
constexpr int wholeProgress = 1000;

} // namespace

JobProgress::JobProgress(QWidget &window, QString name, QString title, std::function<void()> cancel)
    : m_window(window), m_name(std::move(name)), m_title(std::move(title)), m_cancel(std::move(cancel)) {}

JobProgress::~JobProgress() { end(); }

void JobProgress::show(double part, const QString &what) {
  if (!m_dialog)
    open();
  m_dialog->setLabelText(what);
  m_dialog->setRange(0, part < 0 ? 0 : wholeProgress);
  if (part >= 0)
    m_dialog->setValue(static_cast<int>(part * wholeProgress));
}

void JobProgress::open() {
  m_dialog = new QProgressDialog(&m_window);
  m_dialog->setObjectName(m_name);
  m_dialog->setWindowTitle(m_title);
  m_dialog->setMinimumDuration(longestSilence);
  m_dialog->setValue(0); // from when on that counts
  m_dialog->setAutoReset(false);
  m_dialog->setAutoClose(false);
  QObject::connect(m_dialog, &QProgressDialog::canceled, m_dialog, [this] { m_cancel(); });
}

void JobProgress::end() {
  if (!m_dialog)
    return;
  m_dialog->disconnect(); // closing it would cancel the next
  m_dialog->reset();      // or it would be shown after its silence
  m_dialog->hide();
  m_dialog->deleteLater();
  m_dialog = nullptr;
}

} // namespace halfspace
