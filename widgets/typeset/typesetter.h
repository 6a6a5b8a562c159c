// LaTeX to pictures.
#pragma once

#include "widgets/typeset/math_picture.h"

#include <QCache>

#include <memory>

namespace halfspace {

class TypesetWorker;

/// Makes the pictures of formulas, at once. One for the program; lives on the thread of the user interface.
class Typesetter {
public:
  using Picture = std::shared_ptr<const MathPicture>;

  /// A formula that takes longer is given up. A long one takes 10 ms.
  static constexpr int patienceMilliseconds = 1500;

  Typesetter();
  ~Typesetter();
  Typesetter(const Typesetter &) = delete;
  Typesetter &operator=(const Typesetter &) = delete;

  /// The formula, never null: LaTeX that cannot be read gives a picture of its source, with an error.
  [[nodiscard]] Picture picture(const QString &latex) const;

private:
  mutable QCache<QString, Picture> m_cache;
  std::unique_ptr<TypesetWorker> m_worker;
};

} // namespace halfspace
