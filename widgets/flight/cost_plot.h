// What it costs to find the nearest hit, measured on the spot.
#pragma once

#include "widgets/flight/cost_curves.h"
#include "widgets/latest_job.h"

#include <QString>

#include <optional>

class QLabel;
class QPushButton;
class QToolButton;

namespace halfspace {

/// Fires one shot at the scene and at ever larger fields when it is told to, in a thread of its own, and
/// plots each cost as it is measured. Its destructor waits until a tree that is being made is ready.
class CostPlot : public QWidget {
  Q_OBJECT
public:
  explicit CostPlot(QWidget *parent = nullptr);

  /// What is fired when it is measured the next time; nothing: there is nothing to measure.
  void setAim(std::optional<Aim> aim);
  /// Larger fields are left out.
  void setMost(std::size_t triangles);
  void setTheme(const Theme &theme);

  [[nodiscard]] bool isMeasuring() const { return m_job.isRunning(); }
  /// In ascending order of their triangles.
  [[nodiscard]] const std::vector<CostPoint> &points() const { return m_points; }
  /// What is measured in the scene itself.
  [[nodiscard]] const std::optional<CostPoint> &inScene() const { return m_inScene; }
  [[nodiscard]] QString sentence() const;

signals:
  void measured(); ///< another point is there
  void ended();    ///< all are, or it was stopped

private:
  void start();
  void stop();
  void add(const CostPoint &point);
  void end(bool lacksMemory);
  [[nodiscard]] QToolButton *quantityButton(CostQuantity quantity, const QString &words,
                                            const QString &explanation);
  void showState();

  std::optional<Aim> m_aim;
  std::optional<Aim> m_measuredAim; ///< of the points
  bool m_lacksMemory = false;       ///< for the points that are missing
  std::size_t m_most = mostMeasured;
  std::vector<CostPoint> m_points;
  std::optional<CostPoint> m_inScene;
  QPushButton *m_measure = nullptr;
  CostCurves *m_curves = nullptr;
  QLabel *m_sentence = nullptr;
  LatestJob m_job; ///< ended before the rest of this
};

} // namespace halfspace
