#include "viewer/number_box.hpp"

#include <QCoreApplication>

namespace aerostat::viewer {

QString expected_text(const QString& least, const QString& most, const QString& kept,
                      NumberKind kind) {
  const QString expected =
      kind == NumberKind::whole
          ? QCoreApplication::translate("NumberBox",
                                        "Expected a whole number from %1 to %2, without marks.")
          : QCoreApplication::translate("NumberBox", "Expected a number from %1 to %2.");
  return expected.arg(least, most) + " " +
         QCoreApplication::translate("NumberBox", "The value is still %1.").arg(kept);
}

}  // namespace aerostat::viewer
