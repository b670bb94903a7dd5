#include "viewer/number_text.hpp"

#include <QStringList>
#include <algorithm>
#include <cmath>

namespace aerostat::viewer {
namespace {

constexpr char16_t kArabicDecimal = 0x066B, kArabicGroup = 0x066C, kArabicComma = 0x060C;
constexpr char16_t kMinus = 0x2212, kRightQuote = 0x2019;

bool is_direction_mark(QChar c) {
  const char16_t code = c.unicode();
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Returns one character for all characters with the same meaning. Other characters are returned
/// unchanged.
QChar plain(QChar c) {
  if (c.isSpace()) return u' ';
  if (c.decompositionTag() == QChar::Wide) return plain(c.decomposition().front());
  switch (c.unicode()) {
    case kMinus:
      return u'-';
    case kArabicComma:
      return u',';
    case kArabicGroup:
    case kRightQuote:
      return u'\'';
    default:
      return c.toLower();
  }
}

QString in_plain_marks(const QString& text) {
  QString result;
  for (const QChar c : with_ascii_digits(text)) {
    if (!is_direction_mark(c)) result += plain(c);
  }
  return result.trimmed();
}

bool is_digit(QChar c) {
  return c >= u'0' && c <= u'9';
}

/// Removes a sign from the front of the text and returns it.
QString take_sign(QString& text) {
  if (text.isEmpty() || (text[0] != u'-' && text[0] != u'+')) return {};
  const QString sign = text.left(1);
  text.remove(0, 1);
  return sign;
}

bool are_digits(const QString& text) {
  return std::all_of(text.begin(), text.end(), is_digit);
}

/// Returns all characters of the text that are not digits, in their order.
QString marks_of(const QString& text) {
  QString marks;
  for (const QChar c : text) {
    if (!is_digit(c)) marks += c;
  }
  return marks;
}

/// Returns the position of the decimal mark, or the length of the text if there is none.
qsizetype decimal_place(const QString& text) {
  const QString marks = marks_of(text);
  if (marks.isEmpty()) return text.size();
  const QChar last = marks.back();
  const bool may_be = last == kArabicDecimal || last == u'.' || last == u',';
  return may_be && marks.count(last) == 1 ? text.lastIndexOf(last) : text.size();
}

/// Returns a text such as "1 234 567" or "12,34,567" without its group marks, or nothing if the
/// groups are wrong.
std::optional<QString> without_groups(QString text) {
  const QString marks = marks_of(text);
  if (marks.isEmpty()) return text;
  const QChar mark = marks[0];
  if (marks.count(mark) != marks.size() || !QStringLiteral("., '").contains(mark)) return {};
  const QStringList groups = text.split(mark);
  const qsizetype middle = groups.size() > 2 ? groups[1].size() : 3;
  if (groups.back().size() != 3 || (middle != 2 && middle != 3)) return {};
  if (groups[0].isEmpty() || groups[0].size() > middle || groups[0][0] == u'0') return {};
  for (qsizetype i = 1; i + 1 < groups.size(); ++i) {
    if (groups[i].size() != middle) return {};
  }
  return text.remove(mark);
}

}  // namespace

QString with_ascii_digits(QString text) {
  for (QChar& c : text) {
    if (c.digitValue() >= 0 && c.category() == QChar::Number_DecimalDigit) {
      c = QChar(u'0' + static_cast<char16_t>(c.digitValue()));
    }
  }
  return text;
}

std::optional<double> read_number(const QString& text, NumberKind kind) {
  QString mantissa = in_plain_marks(text);
  const QString sign = take_sign(mantissa);
  QString exponent;
  if (const qsizetype place = mantissa.indexOf(u'e'); place >= 0) {
    exponent = mantissa.mid(place + 1);
    mantissa.truncate(place);
    const QString exponent_sign = take_sign(exponent);
    if (exponent.isEmpty() || !are_digits(exponent)) return {};
    exponent = "e" + exponent_sign + exponent;
  }
  const qsizetype place = decimal_place(mantissa);
  const QString fraction = mantissa.mid(place + 1);
  const auto whole = without_groups(mantissa.left(place));
  if (!whole || !are_digits(fraction) || whole->size() + fraction.size() == 0) return {};
  if (kind == NumberKind::whole && place < mantissa.size()) return {};
  bool is_number = false;
  const double value = (sign + "0" + *whole + "." + fraction + "0" + exponent).toDouble(&is_number);
  if (!is_number || !std::isfinite(value)) return {};
  if (kind == NumberKind::whole && value != std::round(value)) return {};
  return value;
}

}  // namespace aerostat::viewer
