#include "widgets/typeset/typeset_worker.h"

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

} // namespace

TypesetWorker::TypesetWorker() : m_thread([this] { run(); }) {}

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
    auto formula = std::make_shared<const MathPicture>(pictureOf(typeset, *m_current));
    {
      const std::lock_guard lock(m_mutex);
      m_made.push_back({*m_current, std::move(formula)});
      m_current.reset();
    }
    m_result.notify_all();
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

void TypesetWorker::setQueue(const QStringList &orders) {
  {
    const std::lock_guard lock(m_mutex);
    m_queue = orders;
    if (m_current)
      m_queue.removeAll(*m_current);
    for (const Made &made : m_made)
      m_queue.removeAll(made.latex);
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

} // namespace halfspace
