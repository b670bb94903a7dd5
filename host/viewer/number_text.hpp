#pragma once

#include <QString>
#include <optional>

namespace aerostat::viewer {

enum class NumberKind { decimal, whole };

/// Returns the number that a text means to a reader in any country. Returns nothing if the text is
/// not a number or is ambiguous. The locale has no influence:
/// - The digits may be of any script, the minus sign of any kind, and an exponent follows "e".
/// - A single dot or comma is the decimal mark, so "1.234" and "1,234" are both 1.234.
/// - A whole number accepts no single mark, because "1,920" may mean 1920 or be a mistake.
/// - Marks may stand before groups of three digits, or as in India before groups of two.
/// - Group marks are spaces and apostrophes, and dots or commas if they are repeated.
/// - A dot or comma also marks groups if the other mark follows, as in "1.234,5".
std::optional<double> read_number(const QString& text, NumberKind kind);

/// Returns the text with the decimal digits of every script replaced by those of ASCII. The length
/// stays the same.
QString with_ascii_digits(QString text);

}  // namespace aerostat::viewer
