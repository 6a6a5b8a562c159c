// A part of the choices in the export window.
#pragma once

#include "app/export/export_choices.h"

#include <QList>
#include <QVariant>
#include <QWidget>

#include <utility>
#include <vector>

class QComboBox;
class QFormLayout;

namespace halfspace {

/// Fields of what belongs together. Those that the chosen format has no use for are there, but disabled.
class ExportSection : public QWidget {
  Q_OBJECT
public:
  explicit ExportSection(const QString &heading);

  /// Fills the fields.
  virtual void fill(const ExportChoices &choices) = 0;
  /// Enables those that the choices have a use for.
  virtual void enableFor(const ExportChoices &choices) = 0;
  /// Puts down what stands in the fields.
  virtual void put(ExportChoices &choices) const = 0;

  /// The room that the words before its fields need, and have.
  [[nodiscard]] int wordsWidth() const;
  void setWordsWidth(int width);

signals:
  void changed();

protected:
  /// The fields stand there, each behind its words.
  [[nodiscard]] QFormLayout &form() { return *m_form; }
  /// A field that offers one of some things, in their order; `meanings` are kept as its items' data.
  [[nodiscard]] QComboBox &addCombo(const QString &words, const QString &name,
                                    const QList<std::pair<QString, QVariant>> &items);

private:
  [[nodiscard]] std::vector<QWidget *> words() const;

  QFormLayout *m_form;
};

/// Chooses the item with this meaning.
void choose(QComboBox &combo, const QVariant &meaning);

} // namespace halfspace
