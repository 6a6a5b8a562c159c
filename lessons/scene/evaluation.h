// What a scene comes to: an outcome for each of its entries.
#pragma once

#include "lessons/construction/construction.h"
#include "lessons/scene/scene_plan.h"

#include <memory>

namespace halfspace {

/// An object of an entry that later entries can look at.
struct OfferedObject {
  std::string name; ///< within the entry: F; empty for the object that the entry itself is
  std::shared_ptr<const Given<Object>> given;
  std::string whyNot{}; ///< why it is not there in the present case, a sentence; empty where it is
  bool operator==(const OfferedObject &) const = default;
};

/// An entry with its outcome, and what that was made from.
struct EvaluatedEntry {
  std::string name;
  std::string construction; ///< its id; empty for an object
  Naming naming;
  /// In the order of the roles; or the entry's own object, and behind a bound one what it lies on.
  std::vector<std::shared_ptr<const Given<Object>>> looksAt;
  /// Why the entry cannot be told now: what its construction looks at is not there, or there is no place for
  /// the bound object. A sentence; empty for nothing.
  std::string missing{};
  std::shared_ptr<const Outcome> outcome{};
  /// An object as it stands in the scene, a bound one by its freedoms; null for a construction.
  std::shared_ptr<const Given<Object>> own{};
  std::vector<OfferedObject> offers{};
  Look look{};                ///< of the results of a construction
  std::vector<Place> along{}; ///< what a plane was laid through: it is drawn as far as that

  [[nodiscard]] bool isConstruction() const { return !construction.empty(); }
};

/// The outcomes of a scene's entries, from top to bottom, and what they were made from. An entry that a
/// change of the scene did not touch is the same in the evaluations before and after it.
struct Evaluation {
  NamedList<EvaluatedEntry> entries;
  Scene scene{};
  std::shared_ptr<const ScenePlan> plan{}; ///< of that scene; null for the evaluation of none

  /// The entry of this name, or null.
  [[nodiscard]] const EvaluatedEntry *find(std::string_view name) const;
  /// The last construction, or null: it stands for the scene where only one can.
  [[nodiscard]] const EvaluatedEntry *lastConstruction() const;
};

/// Evaluates a scene from top to bottom. An outcome of `before` is taken over where the entry and all that it
/// looks at are what they were then. An entry is left out whose construction does not exist or whose roles
/// name nothing above it of the right kind, and a bound object without a host: no reader passes such ones.
/// One that looks at something that is not there in the present case says so (`missing-object`).
[[nodiscard]] Evaluation evaluate(const Scene &scene, const Evaluation &before = {});

/// What the entry's ray meets of many triangles; nothing where there is no such entry.
[[nodiscard]] const Crossings &crossingsOf(const Evaluation &evaluation, std::string_view entry);

/// Whether a mark of a construction's figure is a result, or draws a coordinate of what it makes.
[[nodiscard]] bool isOfResult(const MarkBase &mark, const EvaluatedEntry &entry);

/// The marks of all entries that are not hidden, without the labels that somebody has hidden.
[[nodiscard]] Figure figureOf(const Evaluation &evaluation);

/// A line of an entry with the id that it has in the scene's working: `distance.f`.
[[nodiscard]] WorkingLine lineOf(const EvaluatedEntry &entry, const std::string &id);
/// The name of the entry that the line of a scene's working belongs to.
[[nodiscard]] std::string entryOf(const std::string &lineId);

/// All lines of all constructions.
[[nodiscard]] Working workingOf(const Evaluation &evaluation);

} // namespace halfspace
