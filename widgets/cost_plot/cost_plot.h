// What it costs to find the nearest hit, measured on the spot.
#pragma once

#include "widgets/cost_plot/cost_curves.h"
#include "widgets/latest_job.h"

#include <QString>

#include <functional>
#include <optional>

class QLabel;
class QPushButton;
class QToolButton;

namespace halfspace {

/// Fires one shot at the scene and at ever larger fields when it is told to, as a job beside the event loop,
/// and plots each cost as it is measured.
class CostPlot : public QWidget {
  Q_OBJECT
public:
  /// As measureCost does.
  using Measure = std::function<void(const Aim &, const std::atomic<bool> &cancelled, const TellCost &,
                                     std::size_t most)>;

  /// The job outlives the plot. Who shares it among several stops the others when one has `started`.
  explicit CostPlot(LatestJob &job, Measure measure = measureCost, QWidget *parent = nullptr);
  /// Cancels the job if it is its own, and does not wait: a tree may just be made.
  ~CostPlot() override;

  /// What is fired when it is measured the next time; nothing: there is nothing to measure.
  void setAim(std::optional<Aim> aim);
  /// Larger fields are left out.
  void setMost(std::size_t triangles);
  void setTheme(const Theme &theme);

  /// Nothing happens where it does not measure.
  void stop();
  [[nodiscard]] bool isMeasuring() const { return m_isMeasuring; }
  /// In ascending order of their triangles.
  [[nodiscard]] const std::vector<CostPoint> &points() const { return m_points; }
  /// What is measured in the scene itself.
  [[nodiscard]] const std::optional<CostPoint> &inScene() const { return m_inScene; }
  [[nodiscard]] QString sentence() const;

signals:
  void started();
  void measured(); ///< another point is there
  void ended();    ///< all are, or it was stopped

private:
  void start();
  void add(const CostPoint &point);
  void end(bool lacksMemory);
  [[nodiscard]] QToolButton *quantityButton(CostQuantity quantity, const QString &words,
                                            const QString &explanation);
  void showPoints();
  void showState();

  LatestJob &m_job;
  Measure m_measuring;
  bool m_isMeasuring = false;
  std::optional<Aim> m_aim;
  std::optional<Aim> m_measuredAim; ///< of the points
  bool m_lacksMemory = false;       ///< for the points that are missing
  std::size_t m_most = mostMeasured;
  std::vector<CostPoint> m_points;
  std::optional<CostPoint> m_inScene;
  QPushButton *m_measure = nullptr;
  CostCurves *m_curves = nullptr;
  QLabel *m_sentence = nullptr;
};

} // namespace halfspace
