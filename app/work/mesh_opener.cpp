#include "app/work/mesh_opener.h"

#include <QApplication>

#include <utility>

namespace halfspace {
namespace {

/// After so many milliseconds it is looked again whether a mesh that waits can be handed out.
constexpr int nextLook = 100;

} // namespace

MeshOpener::MeshOpener(QWidget &window, std::function<bool()> isInHand)
    : QObject(&window), m_isInHand(std::move(isInHand)), m_loader(this),
      m_progress(window, "meshProgress", tr("Open mesh"), [this] { m_loader.cancel(); }) {
  m_nextLook.setSingleShot(true);
  m_nextLook.setInterval(nextLook);
  connect(&m_nextLook, &QTimer::timeout, this, &MeshOpener::handOut);
  connect(&m_loader, &MeshLoader::progressed, this,
          [this](double part, const QString &what) { m_progress.show(part, what); });
  connect(&m_loader, &MeshLoader::loaded, this, [this](const LoadedMesh &mesh) {
    m_progress.end();
    m_waiting = mesh;
    handOut();
  });
  connect(&m_loader, &MeshLoader::failed, this, [this](const QString &sentence) {
    m_progress.end();
    emit failed(sentence);
  });
  connect(&m_loader, &MeshLoader::cancelled, this, [this] { m_progress.end(); });
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

void MeshOpener::handOut() {
  if (m_isInHand() || QApplication::activeModalWidget())
    return m_nextLook.start();
  if (const auto mesh = std::exchange(m_waiting, {}))
    emit opened(*mesh);
}

} // namespace halfspace
