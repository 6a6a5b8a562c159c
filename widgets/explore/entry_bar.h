// The bar above a scene in which everything can be typed: entries, and what the menus do.
#pragma once

#include "widgets/explore/entry_field.h"
#include "widgets/explore/suggestion_list.h"
#include "widgets/picture/theme.h"

class QHBoxLayout;

namespace halfspace {

/// A field, with a sentence and suggestions over what stands below it. It knows nothing of scenes: who
/// does tells it what to suggest, and hears what was entered or taken.
class EntryBar : public QWidget {
  Q_OBJECT
public:
  explicit EntryBar(QWidget *parent = nullptr);

  [[nodiscard]] QString text() const { return m_field->text(); }
  [[nodiscard]] int cursor() const { return m_field->cursorPosition(); }
  /// Puts a text there, with a part of it selected.
  void setText(const QString &text, EntryField::Part selected);
  void setText(const QString &text) { setText(text, {static_cast<int>(text.size()), 0}); }
  /// What is typed next comes here, in the place of what is there.
  void takeFocus();
  /// What could be meant; the first is chosen already where Enter is to take it.
  void setSuggestions(const std::vector<Suggestion> &all, bool isFirstChosen = false);
  /// A sentence below the field; empty: none.
  void say(const QString &sentence);
  /// What is wrong, and where.
  void complain(const QString &sentence, EntryField::Part part);
  void setTheme(const Theme &theme);
  /// A tool at the right of the field, which becomes its own.
  void addTool(QWidget &tool);

signals:
  void edited(); ///< by the user
  void entered();
  void taken(int suggestion);     ///< and to be done
  void completed(int suggestion); ///< … or only put into the text; the first where none is chosen
  void recalled(int lines);       ///< an earlier line is wanted, −1, or a later one, 1
  void left();                    ///< by Escape
  void linesPasted(const QString &lines);

private:
  [[nodiscard]] SuggestionList &suggestions();
  void step(int rows);
  void enter();

  EntryField *m_field;
  SuggestionList *m_suggestions = nullptr; ///< null before it is first needed: it lies in the window
  QHBoxLayout *m_row;
};

} // namespace halfspace
