#pragma once

#include <clocale>

#include <locale.h>

namespace aerostat {

/// While it lives, the C library reads and writes the numbers of this thread with a dot, in
/// whatever locale the process is: a window toolkit or a driver may have set one whose decimal mark
/// is another.
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
