#include "widgets/typeset/typeset_worker.h"

#include "widgets/typeset/label_painter.h"

#include <QFile>
#include <QJSEngine>

// A resource of a static library is registered by hand; the macro wants to be outside of namespaces.
static void registerMathJax() { Q_INIT_RESOURCE(mathjax); }

namespace halfspace {

namespace {

/// The function of the bundled MathJax that turns LaTeX into SVG, or an error.
QJSValue loadMathJax(QJSEngine &engine) {
  registerMathJax();
  engine.globalObject().setProperty(QStringLiteral("globalThis"), engine.globalObject());
  QFile bundle(QStringLiteral(":/typeset/mathjax.js"));
  if (!bundle.open(QIODevice::ReadOnly))
    return engine.newErrorObject(QJSValue::GenericError, bundle.errorString());
  const QJSValue outcome = engine.evaluate(QString::fromUtf8(bundle.readAll()), bundle.fileName());
  if (outcome.isError())
    return outcome;
  return engine.globalObject().property(QStringLiteral("halfspaceMath")).property(QStringLiteral("typeset"));
}

MathPicture pictureOf(const QJSValue &typeset, const QString &latex) {
  if (latex.size() > TypesetWorker::longestLatex)
    return MathPicture::failed(QStringLiteral("The formula is too long"), latex);
  if (!typeset.isCallable())
    return MathPicture::failed(QStringLiteral("Formulas cannot be typeset: ") + typeset.toString(), latex);
  const QJSValue svg = QJSValue(typeset).call({latex});
  if (svg.isError() || !svg.isString())
    return MathPicture::failed(QStringLiteral("The formula is too complicated"), latex);
  return MathPicture::fromSvg(svg.toString(), latex);
}

TypesetWorker::Made make(const QJSValue &typeset, const TypesetOrder &order) {
  MathPicture formula = pictureOf(typeset, order.latex);
  if (order.label)
    return {order, nullptr, std::make_shared<const LabelPicture>(paintLabel(formula, *order.label))};
  return {order, std::make_shared<const MathPicture>(std::move(formula)), nullptr};
}

} // namespace

TypesetWorker::TypesetWorker(std::function<void()> arrived)
    : m_arrived(std::move(arrived)), m_thread([this] { run(); }) {}

TypesetWorker::~TypesetWorker() {
  // The formula in work is waited for: interrupting a running script, and at once ending its engine, crashes
  // in Qt 5.15.
  {
    const std::lock_guard lock(m_mutex);
    m_ending = true;
  }
  m_work.notify_all();
  m_thread.join();
}

void TypesetWorker::run() {
  QJSEngine engine;
  {
    const std::lock_guard lock(m_mutex);
    m_engine = &engine;
  }
  const QJSValue typeset = loadMathJax(engine);
  while (takeNext()) {
    TypesetWorker::Made made = make(typeset, *m_current);
    bool first = false;
    {
      const std::lock_guard lock(m_mutex);
      first = m_made.empty();
      m_made.push_back(std::move(made));
      m_current.reset();
    }
    m_result.notify_all();
    if (first)
      m_arrived();
  }
  const std::lock_guard lock(m_mutex);
  m_engine = nullptr;
}

bool TypesetWorker::takeNext() {
  std::unique_lock lock(m_mutex);
  m_work.wait(lock, [this] { return m_ending || !m_queue.isEmpty(); });
  if (m_ending)
    return false;
  m_current = m_queue.takeFirst();
  m_started = Clock::now();
  m_engine->setInterrupted(false); // the last formula may have been given up
  return true;
}

void TypesetWorker::setQueue(const QList<TypesetOrder> &orders) {
  {
    const std::lock_guard lock(m_mutex);
    m_queue = orders;
    if (m_current)
      m_queue.removeAll(*m_current);
    for (const Made &made : m_made)
      m_queue.removeAll(made.order);
  }
  m_work.notify_all();
}

std::vector<TypesetWorker::Made> TypesetWorker::takeMade() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_made, {});
}

void TypesetWorker::waitForMade(std::chrono::milliseconds time) {
  std::unique_lock lock(m_mutex);
  m_result.wait_for(lock, time, [this] { return !m_made.empty(); });
}

void TypesetWorker::giveUpAfter(std::chrono::milliseconds patience) {
  const std::lock_guard lock(m_mutex);
  if (m_engine && m_current && Clock::now() - m_started > patience)
    m_engine->setInterrupted(true);
}

bool TypesetWorker::isIdle() const {
  const std::lock_guard lock(m_mutex);
  return m_queue.isEmpty() && !m_current && m_made.empty();
}

} // namespace halfspace
