#include "viewer/sun_panel.hpp"

#include <QCalendarWidget>
#include <QCheckBox>
#include <QCoreApplication>
#include <QDateEdit>
#include <QFormLayout>
#include <QRegularExpression>
#include <QTimeEdit>
#include <QVBoxLayout>
#include <cmath>

#include "scene/field_rule.hpp"
#include "viewer/iso_edit.hpp"
#include "viewer/number_box.hpp"
#include "viewer/sun_disc.hpp"

namespace aerostat::viewer {
namespace {

const QStringList kPointers = {"/sun/direction",    "/sun/azimuth_deg", "/sun/elevation_deg",
                               "/sun/date",         "/sun/time",        "/sun/latitude_deg",
                               "/sun/longitude_deg"};

QDoubleSpinBox* degrees_box(const char* pointer, double step, int decimals) {
  const scene::FieldRule rule = scene::field_rule(pointer);
  auto* box = new NumberBox;
  box->setDecimals(decimals);
  box->setRange(rule.minimum, rule.maximum);
  box->setSingleStep(step);
  box->setSuffix(QStringLiteral("°"));
  box->setFocusPolicy(Qt::StrongFocus);
  box->setObjectName(QString::fromLatin1(pointer));
  box->setToolTip(QCoreApplication::translate("Schema", rule.description.c_str()));
  return box;
}

/// Returns the text of an offset in hours, such as "+02:00" for 2.
QString offset_text(double hours) {
  const int minutes = static_cast<int>(std::lround(hours * 60.0));
  return QStringLiteral("%1%2:%3")
      .arg(QLatin1Char(minutes < 0 ? '-' : '+'))
      .arg(std::abs(minutes) / 60, 2, 10, QLatin1Char('0'))
      .arg(std::abs(minutes) % 60, 2, 10, QLatin1Char('0'));
}

std::string text_of(double value) {
  return QString::number(value, 'g', 12).toStdString();
}

std::string quoted(const QString& text) {
  return QString(QLatin1Char('"') + text + QLatin1Char('"')).toStdString();
}

QString unquoted(QString json) {
  return json.remove(QLatin1Char('"'));
}

}  // namespace

SunPanel::SunPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      disc_(new SunDisc),
      azimuth_(degrees_box("/sun/azimuth_deg", 5.0, 1)),
      elevation_(degrees_box("/sun/elevation_deg", 1.0, 1)),
      by_date_(new QCheckBox(tr("By date, time and place"))),
      date_box_(new QWidget),
      date_(new IsoEdit<QDateEdit>(QDate(2024, 6, 21))),
      time_(new IsoEdit<QTimeEdit>(QTime(6, 30))),
      offset_(new NumberBox),
      latitude_(degrees_box("/sun/latitude_deg", 1.0, 4)),
      longitude_(degrees_box("/sun/longitude_deg", 1.0, 4)) {
  build();
  connect(disc_, &SunDisc::dragged, this, &SunPanel::set_angles);
  connect(disc_, &SunDisc::released, &document, &Document::end_gesture);
  connect(disc_, &SunDisc::reset_asked, this, &SunPanel::reset);
  for (QDoubleSpinBox* box : {azimuth_, elevation_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
      if (!showing_) set_angles(azimuth_->value(), elevation_->value());
    });
  }
  for (QDoubleSpinBox* box : {offset_, latitude_, longitude_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &SunPanel::set_date);
  }
  connect(date_, &QDateEdit::dateChanged, this, &SunPanel::set_date);
  connect(time_, &QTimeEdit::timeChanged, this, &SunPanel::set_date);
  connect(by_date_, &QCheckBox::clicked, this, [this](bool dated) {
    if (dated) {
      set_date();
    } else {
      set_angles(azimuth_->value(), elevation_->value());
    }
  });
  connect(&document, &Document::changed, this, &SunPanel::refresh);
  refresh();
}

void SunPanel::build() {
  date_->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
  date_->setCalendarPopup(true);
  // The calendar has the locale of the window, because its months have names.
  date_->calendarWidget()->setLocale(locale());
  date_->setDateRange(QDate(1900, 1, 1), QDate(2100, 12, 31));
  date_->setToolTip(tr("The day that gives the sun its place"));
  time_->setDisplayFormat(QStringLiteral("HH:mm"));
  time_->setToolTip(tr("Time of that day, by the clock of the place"));
  offset_->setRange(-12.0, 14.0);
  offset_->setSingleStep(0.5);
  offset_->setDecimals(2);
  offset_->setPrefix(tr("UTC ", "before an offset in hours") + " ");
  offset_->setSuffix(tr(" h"));
  offset_->setToolTip(tr("How far that clock is ahead of universal time"));
  latitude_->setValue(46.5);
  longitude_->setValue(7.7);
  offset_->setValue(2.0);
  auto* dates = new QFormLayout(date_box_);
  dates->setContentsMargins(0, 0, 0, 0);
  dates->addRow(tr("Date"), date_);
  dates->addRow(tr("Time"), time_);
  dates->addRow(tr("Clock"), offset_);
  dates->addRow(tr("Latitude"), latitude_);
  dates->addRow(tr("Longitude"), longitude_);
  auto* angles = new QFormLayout;
  angles->addRow(tr("Azimuth"), azimuth_);
  angles->addRow(tr("Elevation"), elevation_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(disc_);
  layout->addLayout(angles);
  layout->addWidget(by_date_);
  layout->addWidget(date_box_);
}

void SunPanel::set_angles(double azimuth_deg, double elevation_deg) {
  document_.change(tr("Move the Sun"), {{"/sun/azimuth_deg", text_of(azimuth_deg)},
                                        {"/sun/elevation_deg", text_of(elevation_deg)}});
}

void SunPanel::set_date() {
  if (showing_) return;
  const QString time =
      time_->time().toString(QStringLiteral("HH:mm")) + offset_text(offset_->value());
  document_.change(tr("Move the Sun by Date"),
                   {{"/sun/date", quoted(date_->date().toString(Qt::ISODate))},
                    {"/sun/time", quoted(time)},
                    {"/sun/latitude_deg", text_of(latitude_->value())},
                    {"/sun/longitude_deg", text_of(longitude_->value())}});
}

void SunPanel::reset() {
  document_.end_gesture();
  document_.reset(tr("Reset the Sun"), kPointers);
}

bool SunPanel::is_dated() const {
  return !document_.value(QStringLiteral("/sun/date")).isEmpty();
}

void SunPanel::refresh() {
  showing_ = true;
  const double azimuth = document_.value(QStringLiteral("/sun/azimuth_deg")).toDouble();
  const double elevation = document_.value(QStringLiteral("/sun/elevation_deg")).toDouble();
  disc_->show_sun(azimuth, elevation);
  azimuth_->setValue(azimuth);
  elevation_->setValue(elevation);
  const bool dated = is_dated();
  by_date_->setChecked(dated);
  date_box_->setVisible(dated);
  if (dated) show_date(dated);
  showing_ = false;
}

void SunPanel::show_date(bool) {
  date_->setDate(
      QDate::fromString(unquoted(document_.value(QStringLiteral("/sun/date"))), Qt::ISODate));
  const QString text = unquoted(document_.value(QStringLiteral("/sun/time")));
  static const QRegularExpression kTime(
      QStringLiteral("^(\\d\\d:\\d\\d).*?(?:([+-])(\\d\\d):?(\\d\\d))?$"));
  const auto match = kTime.match(text);
  time_->setTime(QTime::fromString(match.captured(1), QStringLiteral("HH:mm")));
  const double hours = match.captured(3).toDouble() + match.captured(4).toDouble() / 60.0;
  offset_->setValue(match.captured(2) == QLatin1String("-") ? -hours : hours);
  latitude_->setValue(document_.value(QStringLiteral("/sun/latitude_deg")).toDouble());
  longitude_->setValue(document_.value(QStringLiteral("/sun/longitude_deg")).toDouble());
}

}  // namespace aerostat::viewer
