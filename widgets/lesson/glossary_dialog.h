// The glossary: what each term means, with a figure, and the way to the lesson that teaches it.
#pragma once

#include "lessons/reading/markdown_text.h"
#include "widgets/picture/theme.h"

#include <QDialog>
#include <QPixmap>

#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;

namespace halfspace {

class NameList;
class RichLabel;
class Typesetter;

/// Stands beside its window, which goes on meanwhile. A list of terms, of which what is typed leaves some,
/// and what is known of the one that is chosen.
class GlossaryDialog : public QDialog {
  Q_OBJECT
public:
  struct Entry {
    QString term;
    QString also; ///< its other forms, between commas; may be empty
    MarkdownText meaning;
    QString lesson; ///< the title of the lesson that teaches it
  };
  /// A figure for the entry with an index, at most of this size; null where there is none.
  using Figure = std::function<QPixmap(std::size_t entry, QSize room)>;

  /// The typesetter must outlive it.
  GlossaryDialog(const Typesetter &typesetter, QWidget *parent);

  /// For the entries that come after it.
  void setTheme(const Theme &theme);
  /// The entries in their order; the term that is chosen stays so. A figure is asked for when its entry is
  /// shown.
  void setEntries(std::vector<Entry> entries, Figure figure);
  /// Comes to the front with an entry chosen; nothing happens to the choice where it has no such term.
  void open(const QString &term = {});

signals:
  void lessonWanted(std::size_t entry);

private:
  void search(const QString &words);
  void showChosen();

  std::vector<Entry> m_entries;
  Figure m_figure;
  QLineEdit *m_search;
  NameList *m_list;
  QLabel *m_term;
  RichLabel *m_meaning;
  QLabel *m_picture;
  QPushButton *m_lesson;
};

} // namespace halfspace
