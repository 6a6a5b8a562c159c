#include "lessons/typed/look_words.h"

namespace halfspace {

std::vector<std::string> lookWords() {
  std::vector<std::string> words = hueNames();
  for (const auto &more : {lineStyleNames(), labelTextNames(), {hiddenField, lockedField}})
    words.insert(words.end(), more.begin(), more.end());
  return words;
}

bool setLook(Entry &entry, std::string_view word) {
  if (const auto hue = findHue(word))
    entry.color = hue;
  else if (const auto style = findLineStyle(word))
    entry.line = style;
  else if (const auto text = findLabelText(word))
    entry.label = text;
  else if (word == hiddenField)
    entry.isHidden = true;
  else if (word == lockedField)
    entry.isLocked = true;
  else
    return false;
  return true;
}

Entry withoutLook(Entry entry) {
  entry.color.reset();
  entry.line.reset();
  entry.label.reset();
  entry.isHidden = entry.isLocked = false;
  return entry;
}

std::vector<std::string> lookWordsOf(const Entry &entry) {
  std::vector<std::string> words;
  if (entry.color)
    words.emplace_back(nameOf(*entry.color));
  if (entry.line)
    words.emplace_back(nameOf(*entry.line));
  if (entry.label)
    words.emplace_back(nameOf(*entry.label));
  if (entry.isHidden)
    words.emplace_back(hiddenField);
  if (entry.isLocked)
    words.emplace_back(lockedField);
  return words;
}

} // namespace halfspace
