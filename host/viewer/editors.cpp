#include "viewer/editors.hpp"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QRandomGenerator>
#include <QToolButton>

#include "viewer/color_editor.hpp"
#include "viewer/number_box.hpp"
#include "viewer/number_editor.hpp"
#include "viewer/triple_editor.hpp"

namespace aerostat::viewer {
namespace {

class NumberRow : public ControlRow {
 public:
  NumberRow(const Control& control, Document& document, QObject* parent)
      : ControlRow(control, document, parent) {
    const bool whole = control.editor == Editor::integer;
    number_ = new NumberEditor(
        {rule().minimum, rule().maximum, control.from, control.to, whole ? 0 : control.decimals,
         control.scale == scene::Scale::logarithmic, unit_of(control), none_of(control)});
    connect(number_, &NumberEditor::edited, this, [this, whole](double value) {
      set(whole ? QString::number(static_cast<qint64>(value)) : QString::number(value, 'g', 12));
    });
    connect(number_, &NumberEditor::finished, &document, &Document::end_gesture);
    adopt(number_);
  }

 protected:
  void show(const QString& json) override {
    if (json.isEmpty()) {
      number_->show_automatic();
    } else {
      number_->show_value(json.toDouble());
    }
  }

 private:
  NumberEditor* number_;
};

/// A row with a whole number, a button that draws another number, and a button that resets it.
class SeedRow : public ControlRow {
 public:
  SeedRow(const Control& control, Document& document, QObject* parent)
      : ControlRow(control, document, parent) {
    auto* box = new QWidget;
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    // Seeds go up to 2^32 - 1, which is beyond the int of a QSpinBox.
    number_ = new NumberBox;
    number_->setDecimals(0);
    number_->setRange(rule().minimum, rule().maximum);
    dice_ = new QToolButton;
    dice_->setText(ControlRow::tr("Dice"));
    dice_->setToolTip(ControlRow::tr("Another land"));
    back_ = new QToolButton;
    back_->setText(ControlRow::tr("Back"));
    back_->setToolTip(ControlRow::tr("The seed before the dice was thrown"));
    back_->setEnabled(false);
    layout->addWidget(number_, 1);
    layout->addWidget(dice_);
    layout->addWidget(back_);
    box->setFocusProxy(number_);
    connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { put(value); });
    connect(dice_, &QToolButton::clicked, this, [this, &document] {
      before_.push_back(number_->value());
      back_->setEnabled(true);
      document.end_gesture();
      put(QRandomGenerator::global()->bounded(1, 10000));
    });
    connect(back_, &QToolButton::clicked, this, [this, &document] {
      if (before_.empty()) return;
      const double value = before_.back();
      before_.pop_back();
      back_->setEnabled(!before_.empty());
      document.end_gesture();
      put(value);
    });
    adopt(box);
  }

 protected:
  void show(const QString& json) override { number_->setValue(json.toDouble()); }

 private:
  void put(double value) { set(QString::number(value, 'f', 0)); }

  NumberBox* number_;
  QToolButton* dice_;
  QToolButton* back_;
  std::vector<double> before_;
};

class ToggleRow : public ControlRow {
 public:
  ToggleRow(const Control& control, Document& document, QObject* parent)
      : ControlRow(control, document, parent), box_(new QCheckBox) {
    connect(box_, &QCheckBox::toggled, this,
            [this](bool on) { set(on ? QStringLiteral("true") : QStringLiteral("false")); });
    adopt(box_);
  }

 protected:
  void show(const QString& json) override { box_->setChecked(json == QLatin1String("true")); }

 private:
  QCheckBox* box_;
};

class ChoiceRow : public ControlRow {
 public:
  ChoiceRow(const Control& control, Document& document, QObject* parent)
      : ControlRow(control, document, parent), box_(new QComboBox) {
    for (const std::string& word : rule().words) {
      const QString text = QString::fromStdString(word);
      box_->addItem(word_text(text), "\"" + text + "\"");
    }
    connect(box_, &QComboBox::activated, this,
            [this](int index) { set(box_->itemData(index).toString()); });
    adopt(box_);
  }

 protected:
  void show(const QString& json) override { box_->setCurrentIndex(box_->findData(json)); }

 private:
  QComboBox* box_;
};

class ColorRow : public ControlRow {
 public:
  ColorRow(const Control& control, Document& document, QObject* parent)
      : ControlRow(control, document, parent), color_(new ColorEditor(1, 1, label_of(control))) {
    connect(color_, &ColorEditor::edited, this, [this, &document](const QString& json) {
      document.end_gesture();
      set(json.mid(1, json.size() - 2));
    });
    adopt(color_);
  }

 protected:
  void show(const QString& json) override { color_->show_colors("[" + json + "]"); }

 private:
  ColorEditor* color_;
};

class TripleRow : public ControlRow {
 public:
  TripleRow(const Control& control, Document& document, QObject* parent)
      : ControlRow(control, document, parent),
        triple_(new TripleEditor(rule().minimum, rule().maximum, control.decimals)) {
    connect(triple_, &TripleEditor::edited, this, &TripleRow::set);
    adopt(triple_);
  }

 protected:
  void show(const QString& json) override { triple_->show_values(json); }

 private:
  TripleEditor* triple_;
};

class ColorsRow : public ControlRow {
 public:
  ColorsRow(const Control& control, Document& document, QObject* parent)
      : ControlRow(control, document, parent),
        colors_(new ColorEditor(rule().least_items, rule().most_items, label_of(control))) {
    connect(colors_, &ColorEditor::edited, this, [this, &document](const QString& json) {
      document.end_gesture();
      set(json);
    });
    adopt(colors_);
  }

 protected:
  void show(const QString& json) override { colors_->show_colors(json); }

 private:
  ColorEditor* colors_;
};

}  // namespace

ControlRow* ControlRow::make(const Control& control, Document& document, QObject* parent) {
  switch (control.editor) {
    case Editor::number:
    case Editor::integer:
      return new NumberRow(control, document, parent);
    case Editor::seed:
      return new SeedRow(control, document, parent);
    case Editor::toggle:
      return new ToggleRow(control, document, parent);
    case Editor::choice:
      return new ChoiceRow(control, document, parent);
    case Editor::color:
      return new ColorRow(control, document, parent);
    case Editor::colors:
      return new ColorsRow(control, document, parent);
    case Editor::triple:
      return new TripleRow(control, document, parent);
  }
  return nullptr;
}

ControlRow::ControlRow(const Control& control, Document& document, QObject* parent)
    : QObject(parent),
      control_(control),
      pointer_(QString::fromStdString(control.pointer)),
      document_(document),
      rule_(scene::field_rule(control.pointer)),
      label_(new QLabel(label_of(control))) {}

void ControlRow::adopt(QWidget* editor) {
  editor_ = editor;
  const QString tip = "<p>" + description_of(control_).toHtmlEscaped() + "</p><p><code>" +
                      QString::fromStdString(control_.pointer) + "</code></p>";
  auto* reset_action = new QAction(tr("Reset to the Default"), this);
  connect(reset_action, &QAction::triggered, this, &ControlRow::reset);
  label_->addAction(reset_action);
  label_->setContextMenuPolicy(Qt::ActionsContextMenu);
  label_->installEventFilter(this);
  label_->setBuddy(editor_);
  for (QWidget* widget : {static_cast<QWidget*>(label_), editor_}) {
    widget->setToolTip(tip);
    widget->setAccessibleDescription(description_of(control_));
  }
  editor_->setAccessibleName(label_->text());
  editor_->setObjectName(QString::fromStdString(control_.pointer));
  editor_->installEventFilter(this);
  for (QWidget* child : editor_->findChildren<QWidget*>()) {
    child->installEventFilter(this);
    // A wheel that scrolls the panel must not change a value that happens to be under the mouse.
    if (child->focusPolicy() == Qt::WheelFocus) child->setFocusPolicy(Qt::StrongFocus);
  }
  if (editor_->focusPolicy() == Qt::WheelFocus) editor_->setFocusPolicy(Qt::StrongFocus);
  connect(&document_, &Document::changed, this, &ControlRow::refresh);
  refresh();
}

void ControlRow::set(const QString& json) {
  if (!pointer_.isEmpty()) document_.set(tr("Change %1").arg(label_of(control_)), pointer_, json);
}

void ControlRow::reset() {
  if (pointer_.isEmpty()) return;
  document_.end_gesture();
  document_.reset(tr("Reset %1").arg(label_of(control_)), {pointer_});
}

void ControlRow::refresh() {
  const QList<QWidget*> parts = editor_->findChildren<QWidget*>();
  editor_->blockSignals(true);
  for (QWidget* part : parts) part->blockSignals(true);
  show(pointer_.isEmpty() ? QString() : document_.value(pointer_));
  for (QWidget* part : parts) part->blockSignals(false);
  editor_->blockSignals(false);
  QFont font = label_->font();
  font.setBold(!pointer_.isEmpty() && document_.source().differs(pointer_.toStdString()));
  label_->setFont(font);
}

void ControlRow::bind_to(const QString& pointer) {
  pointer_ = pointer;
  for (QWidget* widget : {static_cast<QWidget*>(label_), editor_}) {
    widget->setEnabled(!pointer.isEmpty());
  }
  refresh();
}

bool ControlRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == label_ && event->type() == QEvent::MouseButtonDblClick) {
    reset();
    return true;
  }
  if (event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Backspace && key->modifiers() == Qt::ControlModifier) {
      reset();
      return true;
    }
  }
  if (event->type() == QEvent::Wheel && watched != label_) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (widget != nullptr && !widget->hasFocus()) {
      event->ignore();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace aerostat::viewer
