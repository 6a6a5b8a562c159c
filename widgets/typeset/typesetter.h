// LaTeX to pictures, on a thread of its own: nothing that is drawn or dragged ever waits for a formula.
#pragma once

#include "widgets/typeset/typeset_worker.h"

#include <QCache>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <map>
#include <memory>

namespace halfspace {

/// Keeps typeset formulas and has missing ones made. Lives on the thread of the user interface; one for the
/// program.
class Typesetter : public QObject {
  Q_OBJECT
public:
  using Picture = std::shared_ptr<const MathPicture>;
  using Label = std::shared_ptr<const LabelPicture>;

  /// A formula that takes longer is given up. A long one takes 10 ms.
  static constexpr int patienceMilliseconds = 1500;

  /// How many shapes the kept formulas have together: about 20 MB.
  static constexpr int usualCapacity = 20'000;
  /// How many labels are kept.
  static constexpr int labelCapacity = 400;

  explicit Typesetter(QObject *parent = nullptr, int capacity = usualCapacity);
  ~Typesetter() override;

  /// What one client waits for. What no client wants any more is not typeset. Must end before the typesetter
  /// does.
  class Request {
  public:
    explicit Request(Typesetter &typesetter);
    ~Request();
    Request(const Request &) = delete;
    Request &operator=(const Request &) = delete;

    /// Replaces what was wanted before. Missing formulas are made in this order.
    void setWanted(const QStringList &formulas);
    /// Whether all wanted formulas have their pictures.
    [[nodiscard]] bool isComplete() const;

  private:
    friend class Typesetter;
    Typesetter &m_typesetter;
    QStringList m_wanted;
    std::map<QString, Picture> m_pictures; ///< of the wanted, held here so that the cache cannot lose them
  };

  /// The label, or null while it is being made: `ready` tells when to ask again. Only the latest
  /// `mostLabelsWaiting` that were asked for are made.
  [[nodiscard]] Label label(const QString &latex, const LabelStyle &style);
  static constexpr int mostLabelsWaiting = 64;

  /// The picture if it is there; asks for nothing.
  [[nodiscard]] Picture known(const QString &latex) const;

  /// Waits for the picture: for exports.
  [[nodiscard]] Picture pictureNow(const QString &latex);

  /// How many formulas and labels wait to be made.
  [[nodiscard]] int queueLength() const;

signals:
  /// Pictures have arrived: one signal for all since the last.
  void ready();

private:
  void announceArrived();
  /// Whether any pictures have arrived since the last time; they are kept then.
  bool takeArrived();
  void keep(const TypesetWorker::Made &made);
  void keepFormula(const QString &latex, const Picture &picture);
  /// What is wanted and not there, each once; labels first, as they belong to what is being dragged.
  [[nodiscard]] QList<TypesetOrder> missing() const;
  /// Tells the worker what is missing.
  void updateQueue();

  QCache<QString, Picture> m_cache;
  std::vector<Request *> m_requests;
  QCache<TypesetOrder, Label> m_labels{labelCapacity};
  QList<TypesetOrder> m_waitingLabels; ///< the latest first
  QTimer m_watch; ///< runs while the worker has work, and ends formulas that take too long
  std::unique_ptr<TypesetWorker> m_worker;
};

} // namespace halfspace
