// Widgets beside each other that go on in the next row where the width ends.
#pragma once

#include <QLayout>

#include <memory>
#include <vector>

namespace halfspace {

/// Lays its items out as words in a paragraph: from left to right (or from right to left, as the language
/// writes), each as wide as its hint and as high as its
/// row, from top to bottom. What is hidden takes no room.
class FlowLayout : public QLayout {
  Q_OBJECT
public:
  explicit FlowLayout(QWidget *parent = nullptr);
  ~FlowLayout() override;

  void addItem(QLayoutItem *item) override;
  [[nodiscard]] int count() const override;
  [[nodiscard]] QLayoutItem *itemAt(int index) const override;
  QLayoutItem *takeAt(int index) override;

  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize minimumSize() const override;
  /// All in one row.
  [[nodiscard]] QSize sizeHint() const override;
  void setGeometry(const QRect &rect) override;

private:
  /// The places of the items in a width, by their order; null for hidden ones.
  [[nodiscard]] std::vector<QRect> placesIn(int width) const;

  std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

} // namespace halfspace
