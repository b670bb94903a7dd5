#include "viewer/triple_editor.hpp"

#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>

#include "viewer/number_box.hpp"

namespace aerostat::viewer {

TripleEditor::TripleEditor(double least, double most, int decimals, QWidget* parent)
    : QWidget(parent), boxes_{new NumberBox, new NumberBox, new NumberBox} {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (QDoubleSpinBox* box : boxes_) {
    box->setDecimals(decimals);
    box->setRange(least, most);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setMinimumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("-00,000.0")) + 16);
    layout->addWidget(box, 1);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TripleEditor::tell);
  }
  setFocusProxy(boxes_[0]);
}

void TripleEditor::show_values(const QString& json) {
  const QJsonArray values = QJsonDocument::fromJson(json.toUtf8()).array();
  for (int i = 0; i < 3; ++i) {
    boxes_[static_cast<std::size_t>(i)]->setValue(values.at(i).toDouble());
  }
}

void TripleEditor::tell() {
  QStringList numbers;
  for (const QDoubleSpinBox* box : boxes_) numbers << QString::number(box->value(), 'g', 12);
  Q_EMIT edited("[" + numbers.join(", ") + "]");
}

}  // namespace aerostat::viewer
