// Numbers, transforms and path data as SVG writes them.
#include "widgets/typeset/svg_reader.h"

#include <array>

namespace halfspace {

namespace {

/// Reads numbers and letters one after the other.
class Scanner {
public:
  explicit Scanner(const QString &text) : m_text(text) {}

  [[nodiscard]] bool atEnd() {
    while (m_next < m_text.size() && (m_text[m_next].isSpace() || m_text[m_next] == u','))
      ++m_next;
    return m_next >= m_text.size();
  }
  [[nodiscard]] bool atNumber() {
    return !atEnd() &&
           (isDigit() || m_text[m_next] == u'-' || m_text[m_next] == u'+' || m_text[m_next] == u'.');
  }
  [[nodiscard]] QChar letter() { return atEnd() ? QChar() : m_text[m_next++]; }

  /// The number here; 0 when there is none, and then a character is passed over so that no loop can hang.
  [[nodiscard]] double number() {
    if (atEnd())
      return 0;
    const int begin = m_next;
    passSign();
    passDigits();
    if (is(u'.')) {
      ++m_next;
      passDigits();
    }
    if (is(u'e') || is(u'E')) {
      ++m_next;
      passSign();
      passDigits();
    }
    if (m_next == begin)
      ++m_next;
    return m_text.mid(begin, m_next - begin).toDouble();
  }

  [[nodiscard]] QPointF point(QPointF origin) {
    const double x = number();
    const double y = number();
    return origin + QPointF(x, y);
  }

private:
  [[nodiscard]] bool is(char16_t character) const {
    return m_next < m_text.size() && m_text[m_next] == QChar(character);
  }
  [[nodiscard]] bool isDigit() const {
    return m_next < m_text.size() && m_text[m_next] >= u'0' && m_text[m_next] <= u'9';
  }
  void passSign() {
    if (is(u'-') || is(u'+'))
      ++m_next;
  }
  void passDigits() {
    while (isDigit())
      ++m_next;
  }

  const QString &m_text;
  int m_next = 0;
};

/// Builds a path command by command.
class PathBuilder {
public:
  explicit PathBuilder(const QString &data) : m_scanner(data) { m_path.setFillRule(Qt::WindingFill); }

  [[nodiscard]] QPainterPath build() {
    while (!m_scanner.atEnd()) {
      if (!m_scanner.atNumber())
        m_command = m_scanner.letter();
      else if (m_command == u'M') // further pairs after a move are lines
        m_command = u'L';
      else if (m_command == u'm')
        m_command = u'l';
      if (!step())
        break;
    }
    return m_path;
  }

private:
  /// Draws one command; false for one that is not known.
  bool step() {
    const QPointF origin = m_command.isLower() ? m_at : QPointF();
    const QChar command = m_command.toUpper();
    switch (command.toLatin1()) {
    case 'M':
      m_path.moveTo(m_at = m_start = m_scanner.point(origin));
      break;
    case 'L':
      m_path.lineTo(m_at = m_scanner.point(origin));
      break;
    case 'H':
      m_at.setX(origin.x() + m_scanner.number());
      m_path.lineTo(m_at);
      break;
    case 'V':
      m_at.setY(origin.y() + m_scanner.number());
      m_path.lineTo(m_at);
      break;
    case 'Q':
    case 'T':
      quadratic(command == u'T', origin);
      break;
    case 'C':
    case 'S':
      cubic(command == u'S', origin);
      break;
    case 'Z':
      m_path.closeSubpath();
      m_at = m_start;
      m_command = QChar(); // a number cannot follow
      break;
    default:
      return false;
    }
    m_last = command;
    return true;
  }

  void quadratic(bool smooth, QPointF origin) {
    if (!smooth)
      m_control = m_scanner.point(origin);
    else
      m_control = m_last == u'Q' || m_last == u'T' ? 2 * m_at - m_control : m_at;
    m_at = m_scanner.point(origin);
    m_path.quadTo(m_control, m_at);
  }

  void cubic(bool smooth, QPointF origin) {
    const bool follows = m_last == u'C' || m_last == u'S';
    const QPointF first = !smooth ? m_scanner.point(origin) : follows ? 2 * m_at - m_control : m_at;
    m_control = m_scanner.point(origin);
    m_at = m_scanner.point(origin);
    m_path.cubicTo(first, m_control, m_at);
  }

  Scanner m_scanner;
  QPainterPath m_path;
  QPointF m_at, m_start, m_control;
  QChar m_command, m_last;
};

QTransform oneTransform(const QString &function, const QVector<double> &values) {
  const auto value = [&](int index, double otherwise) {
    return index < values.size() ? values[index] : otherwise;
  };
  if (function == QLatin1String("translate"))
    return QTransform::fromTranslate(value(0, 0), value(1, 0));
  if (function == QLatin1String("scale"))
    return QTransform::fromScale(value(0, 1), value(1, value(0, 1)));
  if (function == QLatin1String("rotate"))
    return QTransform()
        .translate(value(1, 0), value(2, 0))
        .rotate(value(0, 0))
        .translate(-value(1, 0), -value(2, 0));
  if (function == QLatin1String("matrix") && values.size() == 6)
    return {values[0], values[1], values[2], values[3], values[4], values[5]};
  return {};
}

} // namespace

QPainterPath pathFromSvg(const QString &data) { return PathBuilder(data).build(); }

QTransform transformFromSvg(const QString &text) {
  QTransform whole;
  int begin = 0;
  while (true) {
    const int open = text.indexOf(u'(', begin);
    const int close = text.indexOf(u')', open);
    if (open < 0 || close < 0)
      return whole;
    const QString function = text.mid(begin, open - begin).remove(u',').trimmed();
    whole = oneTransform(function, numbersIn(text.mid(open + 1, close - open - 1))) * whole;
    begin = close + 1;
  }
}

QVector<double> numbersIn(const QString &text) {
  QVector<double> numbers;
  Scanner scanner(text);
  while (!scanner.atEnd())
    if (scanner.atNumber())
      numbers << scanner.number();
    else
      (void)scanner.letter();
  return numbers;
}

} // namespace halfspace
