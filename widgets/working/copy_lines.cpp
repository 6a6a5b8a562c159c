#include "widgets/working/copy_lines.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>

namespace halfspace {
namespace {

struct CopyWords {
  Q_DECLARE_TR_FUNCTIONS(halfspace::CopyWords)
};

} // namespace

void copyLatex(const ShownLines &lines, std::optional<std::size_t> line) {
  QApplication::clipboard()->setText(line ? lines.latexOf(*line) : lines.latex());
}

void showCopyMenu(QWidget &block, const QPoint &globalPlace, const ShownLines &lines,
                  std::optional<std::size_t> line) {
  QMenu menu(&block);
  // The lines may change while the menu is open.
  const auto add = [&](const QString &words, std::optional<std::size_t> copied) {
    menu.addAction(words, &block, [lines, copied] { copyLatex(lines, copied); });
  };
  if (line)
    add(CopyWords::tr("Copy this line as LaTeX"), line);
  add(CopyWords::tr("Copy these lines as LaTeX"), {});
  menu.exec(globalPlace);
}

} // namespace halfspace
