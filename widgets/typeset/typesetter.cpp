#include "widgets/typeset/typesetter.h"

#include "widgets/typeset/typeset_worker.h"

#include <algorithm>

namespace halfspace {

namespace {

constexpr std::chrono::milliseconds patience{Typesetter::patienceMilliseconds};
/// How often somebody looks whether a formula takes too long.
constexpr std::chrono::milliseconds watchInterval{250};
/// How many shapes the kept formulas have together: about 20 MB.
constexpr int capacity = 20'000;

} // namespace

Typesetter::Typesetter() : m_cache(capacity), m_worker(std::make_unique<TypesetWorker>()) {}
Typesetter::~Typesetter() = default;

Typesetter::Picture Typesetter::picture(const QString &latex) const {
  if (const Picture *kept = m_cache.object(latex))
    return *kept;
  m_worker->setQueue({latex});
  std::vector<TypesetWorker::Made> made;
  while (made.empty()) {
    m_worker->waitForMade(watchInterval);
    m_worker->giveUpAfter(patience);
    made = m_worker->takeMade();
  }
  Picture picture = made.front().formula;
  m_cache.insert(latex, new Picture(picture),
                 std::min(capacity, 1 + static_cast<int>(picture->items().size())));
  return picture;
}

} // namespace halfspace
