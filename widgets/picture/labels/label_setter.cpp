#include "widgets/picture/labels/label_setter.h"

#include "widgets/formula/set_formula.h"

#include <unordered_map>
#include <utility>

namespace halfspace {
namespace {

/// More than a picture has, so that whatever is in use stays.
constexpr std::size_t mostLatest = 400;

/// The latest labels, and those that were the latest before: what is asked for again goes from these to
/// those, and the rest goes away with them.
class KeptLabels {
public:
  template <class Set> LabelFormula find(const std::string &latex, Set set) {
    if (const auto kept = m_latest.find(latex); kept != m_latest.end())
      return kept->second;
    if (m_latest.size() >= mostLatest)
      m_earlier = std::exchange(m_latest, {});
    const auto earlier = m_earlier.find(latex);
    return m_latest[latex] = earlier != m_earlier.end() ? earlier->second : set();
  }

private:
  std::unordered_map<std::string, LabelFormula> m_latest;
  std::unordered_map<std::string, LabelFormula> m_earlier;
};

} // namespace

LabelSetter labelSetter(const math::MathFonts &fonts) {
  return [&fonts, kept = std::make_shared<KeptLabels>()](const std::string &latex) {
    return kept->find(
        latex, [&] { return std::make_shared<const math::Layout>(math::setLatex(latex, fonts).layout); });
  };
}

} // namespace halfspace
