#include "widgets/typeset/typesetter.h"

#include "widgets/typeset/typeset_worker.h"

#include <algorithm>
#include <chrono>

namespace halfspace {

namespace {

constexpr std::chrono::milliseconds patience{Typesetter::patienceMilliseconds};
/// How often somebody looks whether a formula takes too long.
constexpr std::chrono::milliseconds watchInterval{250};

} // namespace

Typesetter::Typesetter(QObject *parent, int capacity) : QObject(parent), m_cache(capacity) {
  m_watch.setInterval(watchInterval);
  connect(&m_watch, &QTimer::timeout, this, [this] {
    m_worker->giveUpAfter(patience);
    if (m_worker->isIdle())
      m_watch.stop();
  });
  m_worker = std::make_unique<TypesetWorker>(
      [this] { QMetaObject::invokeMethod(this, &Typesetter::announceArrived, Qt::QueuedConnection); });
}

Typesetter::~Typesetter() = default;

Typesetter::Picture Typesetter::picture(const QString &latex) {
  if (Picture there = known(latex))
    return there;
  m_loose.removeAll(latex);
  m_loose.prepend(latex);
  while (m_loose.size() > looseRequests)
    m_loose.removeLast();
  updateQueue();
  return known(latex); // a source that is refused has its picture at once
}

Typesetter::Picture Typesetter::known(const QString &latex) const {
  if (const Picture *cached = m_cache.object(latex))
    return *cached;
  for (const Request *request : m_requests)
    if (const auto held = request->m_pictures.find(latex); held != request->m_pictures.end())
      return held->second;
  return nullptr;
}

Typesetter::Picture Typesetter::pictureNow(const QString &latex) {
  Request request(*this);
  request.setWanted({latex});
  while (!request.isComplete()) {
    m_worker->waitForMade(watchInterval);
    m_worker->giveUpAfter(patience);
    // The others are told later: they must not redraw in the middle of an export.
    if (takeArrived())
      QMetaObject::invokeMethod(this, &Typesetter::ready, Qt::QueuedConnection);
  }
  return known(latex);
}

int Typesetter::queueLength() const {
  QStringList waiting = m_loose;
  for (const Request *request : m_requests)
    waiting << request->m_wanted;
  waiting.removeDuplicates();
  return static_cast<int>(std::count_if(waiting.cbegin(), waiting.cend(),
                                        [this](const QString &latex) { return !known(latex); }));
}

void Typesetter::announceArrived() {
  if (takeArrived())
    emit ready();
}

bool Typesetter::takeArrived() {
  const std::vector<TypesetWorker::Made> arrived = m_worker->takeMade();
  for (const auto &[latex, picture] : arrived)
    keep(latex, picture);
  return !arrived.empty();
}

void Typesetter::keep(const QString &latex, const Picture &picture) {
  m_loose.removeAll(latex);
  for (Request *request : m_requests)
    if (request->m_wanted.contains(latex))
      request->m_pictures[latex] = picture;
  const int cost =
      std::min(static_cast<int>(m_cache.maxCost()), 1 + static_cast<int>(picture->items().size()));
  m_cache.insert(latex, new Picture(picture), cost);
}

void Typesetter::updateQueue() {
  QStringList queue = m_loose;
  for (const Request *request : m_requests)
    queue << request->m_wanted;
  queue.removeDuplicates();
  const auto refusedOrKnown = [this](const QString &latex) {
    if (known(latex))
      return true;
    if (latex.size() <= longestLatex)
      return false;
    keep(latex, std::make_shared<const MathPicture>(
                    MathPicture::failed(QStringLiteral("The formula is too long"), latex)));
    return true;
  };
  queue.erase(std::remove_if(queue.begin(), queue.end(), refusedOrKnown), queue.end());
  m_worker->setQueue(queue);
  // Not anew for each request, or it would never end a formula while requests keep coming.
  if (!queue.isEmpty() && !m_watch.isActive())
    m_watch.start();
}

Typesetter::Request::Request(Typesetter &typesetter) : m_typesetter(typesetter) {
  m_typesetter.m_requests.push_back(this);
}

Typesetter::Request::~Request() {
  auto &requests = m_typesetter.m_requests;
  requests.erase(std::find(requests.begin(), requests.end(), this));
  m_typesetter.updateQueue();
}

void Typesetter::Request::setWanted(const QStringList &formulas) {
  std::map<QString, Picture> pictures;
  for (const QString &latex : formulas)
    if (Picture there = m_typesetter.known(latex))
      pictures.emplace(latex, std::move(there));
  m_pictures = std::move(pictures);
  m_wanted = formulas;
  m_typesetter.updateQueue();
}

bool Typesetter::Request::isComplete() const {
  return std::all_of(m_wanted.cbegin(), m_wanted.cend(),
                     [this](const QString &latex) { return m_pictures.count(latex) > 0; });
}

} // namespace halfspace
