#include "viewer/message_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>

namespace aerostat::viewer {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), text_(new QLabel), offers_(new QHBoxLayout) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* icon = new QLabel;
  const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
  icon->setPixmap(style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(size, size));
  auto* close = new QPushButton(tr("Dismiss"));
  close->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Period));
  connect(close, &QPushButton::clicked, this, &MessageBar::dismiss);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(icon);
  layout->addWidget(text_, 1);
  layout->addLayout(offers_);
  layout->addWidget(close);
  hide();
}

QString MessageBar::message() const {
  return isHidden() ? QString() : text_->text();
}

void MessageBar::clear_offers() {
  while (QLayoutItem* item = offers_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
}

void MessageBar::show_message(const QString& message, const std::vector<Offer>& offers) {
  clear_offers();
  text_->setText(message);
  text_->setAccessibleName(message);
  for (const Offer& offer : offers) {
    auto* button = new QPushButton(offer.text);
    connect(button, &QPushButton::clicked, this, [this, accept = offer.accept] {
      dismiss();
      accept();
    });
    offers_->addWidget(button);
  }
  show();
}

void MessageBar::dismiss() {
  hide();
  clear_offers();
}

}  // namespace aerostat::viewer
