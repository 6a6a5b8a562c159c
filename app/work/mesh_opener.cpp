#include "app/work/mesh_opener.h"

#include <QApplication>
#include <QProgressDialog>

#include <utility>

namespace halfspace {
namespace {

/// What takes longer, in milliseconds, shows a bar.
constexpr int longestSilence = 400;
/// After so many milliseconds it is looked again whether a mesh that waits can be handed out.
constexpr int nextLook = 100;
/// The bar's steps.
constexpr int wholeProgress = 1000;

} // namespace

MeshOpener::MeshOpener(QWidget &window, std::function<bool()> isInHand)
    : QObject(&window), m_window(window), m_isInHand(std::move(isInHand)), m_loader(this) {
  m_nextLook.setSingleShot(true);
  m_nextLook.setInterval(nextLook);
  connect(&m_nextLook, &QTimer::timeout, this, &MeshOpener::handOut);
  connect(&m_loader, &MeshLoader::progressed, this, &MeshOpener::showProgress);
  connect(&m_loader, &MeshLoader::loaded, this, [this](const LoadedMesh &mesh) {
    endProgress();
    m_waiting = mesh;
    handOut();
  });
  connect(&m_loader, &MeshLoader::failed, this, [this](const QString &sentence) {
    endProgress();
    emit failed(sentence);
  });
  connect(&m_loader, &MeshLoader::cancelled, this, &MeshOpener::endProgress);
}

void MeshOpener::open(const QString &file) {
  m_nextLook.stop();
  m_waiting.reset();
  m_loader.start(file);
}

void MeshOpener::leave() {
  m_loader.cancel();
  m_nextLook.stop();
  m_waiting.reset();
}

void MeshOpener::showProgress(double part, const QString &what) {
  if (!m_progress) {
    m_progress = new QProgressDialog(&m_window);
    m_progress->setObjectName("meshProgress");
    m_progress->setWindowTitle(tr("Open mesh"));
    m_progress->setMinimumDuration(longestSilence);
    m_progress->setValue(0); // from when on that counts
    m_progress->setAutoReset(false);
    m_progress->setAutoClose(false);
    connect(m_progress, &QProgressDialog::canceled, &m_loader, &MeshLoader::cancel);
  }
  m_progress->setLabelText(what);
  m_progress->setRange(0, part < 0 ? 0 : wholeProgress);
  if (part >= 0)
    m_progress->setValue(static_cast<int>(part * wholeProgress));
}

void MeshOpener::endProgress() {
  if (!m_progress)
    return;
  m_progress->disconnect(&m_loader); // closing it would cancel the next
  m_progress->reset();               // or it would be shown after its silence
  m_progress->hide();
  m_progress->deleteLater();
  m_progress = nullptr;
}

void MeshOpener::handOut() {
  if (m_isInHand() || QApplication::activeModalWidget())
    return m_nextLook.start();
  if (const auto mesh = std::exchange(m_waiting, {}))
    emit opened(*mesh);
}

} // namespace halfspace
