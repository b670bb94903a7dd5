#pragma once

#include <clocale>

#include <locale.h>

namespace aerostat {

/// Makes the C library read and write the numbers of this thread with a decimal point while the
/// object lives. A window toolkit or a driver may have set a locale with another decimal mark.
class DotDecimals {
 public:
  DotDecimals()
      : own_(::newlocale(LC_NUMERIC_MASK, "C", ::duplocale(::uselocale(locale_t{})))),
        former_(::uselocale(own_)) {}
  ~DotDecimals() {
    ::uselocale(former_);
    if (own_ != locale_t{}) ::freelocale(own_);
  }
  DotDecimals(const DotDecimals&) = delete;
  DotDecimals& operator=(const DotDecimals&) = delete;

 private:
  locale_t own_;
  locale_t former_;
};

}  // namespace aerostat
