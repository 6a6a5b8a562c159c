// A piece of Markdown with formulas, as tall as its words need.
#pragma once

#include "widgets/rich_text.h"

#include <QWidget>

namespace halfspace {

/// Shows what `setMarkdown` was given last; while formulas are typeset, what was shown before stays.
class RichLabel : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive the label.
  explicit RichLabel(Typesetter &typesetter, QWidget *parent = nullptr);
  ~RichLabel() override;

  void setMarkdown(const QString &markdown);
  void setInk(const QColor &ink);
  /// Whether all that was set is shown.
  [[nodiscard]] bool isSettled() const { return m_shown == m_markdown; }

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent *event) override;
  void changeEvent(QEvent *event) override;

private:
  /// Has the formulas of the newest text made.
  void request();
  void showRequested();
  void build();

  Typesetter &m_typesetter;
  Typesetter::Request m_request;
  QColor m_ink;
  QString m_markdown;  ///< the newest
  QString m_requested; ///< whose formulas are being made
  QString m_shown;
  std::vector<Typesetter::Picture> m_pictures; ///< of what is shown
  std::unique_ptr<QTextDocument> m_document;
};

} // namespace halfspace
