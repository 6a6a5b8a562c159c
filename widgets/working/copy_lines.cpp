#include "widgets/working/copy_lines.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QMimeData>

#include <memory>

namespace halfspace {
namespace {

struct CopyWords {
  Q_DECLARE_TR_FUNCTIONS(halfspace::CopyWords)
};

/// A page of what stands in its body; without the charset some programs take it for Latin-1.
QString htmlPage(const QString &body) {
  return "<!DOCTYPE html><html><head><meta charset=\"utf-8\"></head><body>" + body + "</body></html>";
}

} // namespace

void copyLines(const std::vector<ToldLine> &lines, std::optional<std::size_t> line, DocumentFormat format) {
  const std::string text = line ? formulaText(lines.at(*line), format) : workingText(lines, format);
  auto copied = std::make_unique<QMimeData>();
  copied->setText(QString::fromStdString(text));
  if (format == DocumentFormat::Latex)
    copied->setData("text/x-tex", QByteArray::fromStdString(text));
  if (format == DocumentFormat::MathMl)
    copied->setHtml(htmlPage(copied->text()));
  if (format == DocumentFormat::MathMl &&
      line) // several formulas with words between them are no such document
    copied->setData("application/mathml+xml", QByteArray::fromStdString(text));
  QApplication::clipboard()->setMimeData(copied.release()); // it belongs to the clipboard now
}

void showCopyMenu(QWidget &block, const QPoint &globalPlace, const ShownLines &lines,
                  std::optional<std::size_t> line) {
  QMenu menu(&block);
  // The lines may change while the menu is open.
  const auto add = [&](const QString &words, std::optional<std::size_t> copied, DocumentFormat format) {
    menu.addAction(words, &block, [lines, copied, format] { copyLines(lines.told(), copied, format); });
  };
  if (line) {
    add(CopyWords::tr("Copy this line as LaTeX"), line, DocumentFormat::Latex);
    add(CopyWords::tr("Copy this line as MathML"), line, DocumentFormat::MathMl);
    add(CopyWords::tr("Copy this line as plain text"), line, DocumentFormat::PlainText);
    menu.addSeparator();
  }
  add(CopyWords::tr("Copy these lines as LaTeX"), {}, DocumentFormat::Latex);
  add(CopyWords::tr("Copy these lines as MathML"), {}, DocumentFormat::MathMl);
  add(CopyWords::tr("Copy these lines as plain text"), {}, DocumentFormat::PlainText);
  menu.exec(globalPlace);
}

} // namespace halfspace
