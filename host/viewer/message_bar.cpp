#include "viewer/message_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <vector>

namespace aerostat::viewer {
namespace {

/// The most characters of a message, and of a word before it gets a place to break at. Chosen by
/// eye.
constexpr qsizetype kLongest = 600, kLongestWord = 120;
/// The least width of a button in pixels. If there is little room, the names of devices are cut
/// off. Chosen by eye.
constexpr int kNarrowestButton = 70;
/// The least width of the message beside its buttons, in pixels. If it would be narrower, the
/// buttons stand below the message. Chosen by eye.
constexpr int kNarrowestMessage = 300;

/// Shortens a message. It may name a key of a broken file, which can have megabytes. A long message
/// loses its middle, and words that are wider than the window get places at which they can be
/// broken.
QString shortened(const QString& message) {
  QString text = message;
  if (text.size() > kLongest) {
    text = text.left(kLongest / 2) + QStringLiteral(" … ") + text.right(kLongest / 2);
  }
  qsizetype word = 0;
  for (qsizetype i = 0; i < text.size(); ++i) {
    word = text[i].isSpace() ? 0 : word + 1;
    if (word == kLongestWord) {
      text.insert(i + 1, QChar(0x200B));
      word = -1;
    }
  }
  return text;
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), text_(new QLabel), offers_(new QHBoxLayout) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  // The least width is set, because it would otherwise be that of the longest word.
  text_->setMinimumWidth(120);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* icon = new QLabel;
  const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
  icon->setPixmap(style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(size, size));
  auto* close = new QPushButton(tr("Dismiss"));
  close->setMinimumWidth(kNarrowestButton);
  close->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Period));
  connect(close, &QPushButton::clicked, this, &MessageBar::dismiss);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(icon);
  layout->addWidget(text_, 1);
  layout->addLayout(offers_);
  offers_->addWidget(close);
  hide();
}

QString MessageBar::message() const {
  return isHidden() ? QString() : text_->text();
}

void MessageBar::clear_offers() {
  // The last button dismisses the message and stays.
  while (offers_->count() > 1) {
    QLayoutItem* item = offers_->takeAt(0);
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
}

void MessageBar::show_message(const QString& message, const std::vector<Offer>& offers) {
  clear_offers();
  const QString shown = shortened(message);
  text_->setText(shown);
  text_->setAccessibleName(shown);
  for (const Offer& offer : offers) {
    auto* button = new QPushButton(offer.text);
    button->setMinimumWidth(kNarrowestButton);
    button->setToolTip(offer.text);
    connect(button, &QPushButton::clicked, this, [this, accept = offer.accept] {
      dismiss();
      accept();
    });
    offers_->insertWidget(offers_->count() - 1, button);
  }
  arrange(parentWidget() != nullptr ? parentWidget()->width() : width());
  show();
}

void MessageBar::arrange(int width) {
  int buttons = 0;
  for (int i = 0; i < offers_->count(); ++i) buttons += offers_->itemAt(i)->sizeHint().width();
  offers_->setDirection(width < kNarrowestMessage + buttons ? QBoxLayout::TopToBottom
                                                            : QBoxLayout::LeftToRight);
}

void MessageBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  arrange(width());
}

void MessageBar::dismiss() {
  hide();
  clear_offers();
}

}  // namespace aerostat::viewer
