#include "app/new_lesson.h"

#include "lessons/files/write_file.h"
#include "lessons/lesson/lesson.h"
#include "lessons/text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// What stands behind the id: a little of everything that a lesson can have.
constexpr std::string_view beginning = R"(
title: My first lesson
chapter: Own lessons
sources: []
scene:
  - {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}
  - {name: Q, point: [11, 15, 8]}
  - {name: distance, construction: signed-distance, of: {E: E, Q: Q}}
camera: {from: [1.25, -0.1, 0.6], at: [6, 8, 4], height: 21}
---
## Ask first

A question hides the numbers until it is answered. What the learner reads is Markdown, with formulas between dollars.

```predict
ask: On which side of the plane is $Q$?
answer: side
choices:
  positive: On the side that $\vec n$ points to
  negative: On the other side
  on: Exactly in the plane
why: Put $Q$ into the right side of the plane's equation. The sign of the result tells.
```

Below it stand the worked lines that you name. Live values stand in braces: $f(Q)$ is now {f}.

```lines
f, side
```

## Give something to do

The program notices when a task is done.

```lines
length, distance
```

```draw
F
```

```task
do: Drag $Q$ until its distance from the plane is exactly 6.
when: signed_distance = 6
```
)";

} // namespace

Result<std::filesystem::path> writeNewLesson(const std::string &id, const std::filesystem::path &folder) {
  const std::string text = "---\nid: " + id + std::string(beginning);
  const std::filesystem::path file = folder / (id + ".md");
  if (const auto lesson = parseLesson(text, file.string()); !lesson || lesson->id != id)
    return Problem{words("“{id}” cannot be the id of a lesson: it is made of small letters, digits and "
                         "hyphens, and begins with no hyphen.",
                         {{"id", shortened(id)}}),
                   "", 0, ""};
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, error)))
    return Problem{words("The file is there already, and stays as it is."), file.string(), 0, ""};
  if (const auto problem = writeFile(file, text))
    return *problem;
  return file;
}

} // namespace halfspace
