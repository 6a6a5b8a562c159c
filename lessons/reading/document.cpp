#include "lessons/reading/document.h"

#include "lessons/guess.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <charconv>

namespace halfspace {

const DocumentNode *DocumentNode::find(std::string_view name) const {
  if (kind != Kind::Map)
    return nullptr;
  for (const DocumentNode &child : children)
    if (child.key == name)
      return &child;
  return nullptr;
}

void FieldReader::allowOnly(std::initializer_list<std::string_view> keys) {
  if (m_node.kind != DocumentNode::Kind::Map)
    return complain(m_node, m_path, words("Here named fields are expected, as `name: value`."));
  const std::vector<std::string> known(keys.begin(), keys.end());
  for (const DocumentNode &child : m_node.children)
    if (std::find(known.begin(), known.end(), child.key) == known.end())
      complain(child, pathOf(shortened(child.key)),
               withGuess(words("There is no such field. Remove it or mend its name."), child.key, known));
}

const DocumentNode *FieldReader::required(std::string_view key) {
  const DocumentNode *node = m_node.find(key);
  if (!node)
    complain(m_node, pathOf(key), words("This field is missing. Add it."));
  return node;
}

std::string FieldReader::text(std::string_view key, const std::optional<std::string> &fallback) {
  const DocumentNode *node = fallback ? optional(key) : required(key);
  if (!node)
    return fallback.value_or("");
  if (node->kind != DocumentNode::Kind::Text)
    complain(*node, pathOf(key), words("Here a text is expected, in quotes where the file is JSON."));
  else if (node->text.size() > maxFieldText)
    complain(*node, pathOf(key),
             words("This text is too long: at most {limit} bytes are read.",
                   {{"limit", std::to_string(maxFieldText)}}));
  else
    return node->text;
  return "";
}

std::string FieldReader::lessonId(std::string_view key) {
  constexpr std::size_t longest = 64;
  std::string id = text(key);
  const bool good = !id.empty() && id.size() <= longest && id.front() != '-' &&
                    id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
  if (!good)
    if (const DocumentNode *node = m_node.find(key))
      complain(*node, pathOf(key),
               words("An id is made of small letters, digits and hyphens, at most {limit}, and begins with "
                     "no hyphen.",
                     {{"limit", std::to_string(longest)}}));
  return id;
}

int FieldReader::integer(std::string_view key, int lowest, int highest, std::optional<int> fallback) {
  const DocumentNode *node = fallback ? optional(key) : required(key);
  if (!node)
    return fallback.value_or(lowest);
  int value = 0;
  const char *end = node->text.data() + node->text.size();
  const auto [stop, error] = std::from_chars(node->text.data(), end, value);
  if (node->spellsNumber() && error == std::errc() && stop == end && value >= lowest && value <= highest)
    return value;
  complain(*node, pathOf(key),
           words("Here a whole number from {lowest} to {highest} is expected.",
                 {{"lowest", std::to_string(lowest)}, {"highest", std::to_string(highest)}}));
  return lowest;
}

bool FieldReader::truth(std::string_view key, bool fallback) {
  const DocumentNode *node = optional(key);
  if (!node)
    return fallback;
  if (node->text != "true" && node->text != "false")
    complain(*node, pathOf(key), words("Here true or false is expected."));
  return node->text == "true";
}

std::string FieldReader::pathOf(std::string_view key) const {
  if (m_path.empty() || key.empty())
    return m_path + std::string(key);
  return m_path + "." + std::string(key);
}

void FieldReader::complain(const DocumentNode &where, std::string field, std::string sentence) {
  keep({std::move(sentence), m_file, where.line, std::move(field)});
}

void FieldReader::keep(Problem problem) {
  if (!m_problem)
    m_problem = std::move(problem);
}

int lineAt(std::string_view text, std::size_t place) {
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

std::string notText() {
  return words("The file holds bytes here that are no text in UTF-8: it is damaged, or of another kind.");
}

} // namespace halfspace
