#pragma once

#include <QString>
#include <optional>

namespace aerostat::viewer {

enum class NumberKind { decimal, whole };

/// The number that a text says to a reader of any country; nothing where it says none, or where it
/// may mean two. The locale plays no part:
/// - Digits of any script, a minus sign of any kind, an exponent after "e".
/// - A single dot or comma is the decimal mark, so "1.234" and "1,234" are both 1.234. A whole
///   number takes none: "1,920" may be meant as 1920 or by mistake.
/// - Marks before groups of three digits, or of two before a last one of three as in India: spaces
///   and apostrophes; dots or commas if they are repeated, or if the other mark follows, as in
///   "1.234,5".
std::optional<double> read_number(const QString& text, NumberKind kind);

/// The text with decimal digits of any script as those of ASCII; as long as before.
QString with_ascii_digits(QString text);

}  // namespace aerostat::viewer
