#include "widgets/typeset/typesetter.h"

#include <QSet>

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

Typesetter::Label Typesetter::label(const QString &latex, const LabelStyle &style) {
  const TypesetOrder order{latex, style};
  if (const Label *there = m_labels.object(order))
    return *there;
  m_waitingLabels.removeAll(order);
  m_waitingLabels.prepend(order);
  while (m_waitingLabels.size() > mostLabelsWaiting)
    m_waitingLabels.removeLast();
  updateQueue();
  return nullptr;
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

int Typesetter::queueLength() const { return static_cast<int>(missing().size()); }

void Typesetter::announceArrived() {
  if (takeArrived())
    emit ready();
}

bool Typesetter::takeArrived() {
  const std::vector<TypesetWorker::Made> arrived = m_worker->takeMade();
  for (const TypesetWorker::Made &made : arrived)
    keep(made);
  return !arrived.empty();
}

void Typesetter::keep(const TypesetWorker::Made &made) {
  if (made.formula)
    return keepFormula(made.order.latex, made.formula);
  m_waitingLabels.removeAll(made.order);
  m_labels.insert(made.order, new Label(made.label));
}

void Typesetter::keepFormula(const QString &latex, const Picture &picture) {
  for (Request *request : m_requests)
    if (request->m_wanted.contains(latex))
      request->m_pictures[latex] = picture;
  const int cost =
      std::min(static_cast<int>(m_cache.maxCost()), 1 + static_cast<int>(picture->items().size()));
  m_cache.insert(latex, new Picture(picture), cost);
}

QList<TypesetOrder> Typesetter::missing() const {
  QList<TypesetOrder> orders = m_waitingLabels;
  QSet<QString> formulas;
  for (const Request *request : m_requests)
    for (const QString &latex : request->m_wanted)
      if (!formulas.contains(latex) && !known(latex)) {
        formulas.insert(latex);
        orders.push_back({latex, {}});
      }
  return orders;
}

void Typesetter::updateQueue() {
  const QList<TypesetOrder> queue = missing();
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
