#include <QCoreApplication>

#include "viewer/controls.hpp"

namespace aerostat::viewer {
namespace {

using scene::EditGroup;

constexpr bool kFolded = true;

constexpr ControlGroup kGroups[] = {
    {EditGroup::land, Panel::land, QT_TRANSLATE_NOOP("Controls", "Land")},
    {EditGroup::snow_and_water, Panel::land, QT_TRANSLATE_NOOP("Controls", "Snow and water")},
    {EditGroup::plants, Panel::land, QT_TRANSLATE_NOOP("Controls", "Plants")},
    {EditGroup::model, Panel::land, QT_TRANSLATE_NOOP("Controls", "Models from files"), kFolded},
    {EditGroup::shape, Panel::land, QT_TRANSLATE_NOOP("Controls", "Shape in detail"), kFolded},
    {EditGroup::dunes, Panel::land, QT_TRANSLATE_NOOP("Controls", "Dunes"), kFolded},
    {EditGroup::ground, Panel::land, QT_TRANSLATE_NOOP("Controls", "Ground"), kFolded},
    {EditGroup::sea, Panel::land, QT_TRANSLATE_NOOP("Controls", "Sea in detail"), kFolded},
    {EditGroup::mood, Panel::light},
    {EditGroup::sun, Panel::light},
    {EditGroup::night, Panel::light, QT_TRANSLATE_NOOP("Controls", "Moon and stars"), kFolded},
    {EditGroup::air, Panel::light, QT_TRANSLATE_NOOP("Controls", "Air")},
    {EditGroup::clouds, Panel::light, QT_TRANSLATE_NOOP("Controls", "Clouds")},
    {EditGroup::sky_light, Panel::light, QT_TRANSLATE_NOOP("Controls", "Light of the sky")},
    {EditGroup::lamps, Panel::light, QT_TRANSLATE_NOOP("Controls", "Lamps"), kFolded},
    {EditGroup::air_in_detail, Panel::light, QT_TRANSLATE_NOOP("Controls", "Air in detail"),
     kFolded},
    {EditGroup::balloon, Panel::balloon, QT_TRANSLATE_NOOP("Controls", "Balloon")},
    {EditGroup::envelope, Panel::balloon, QT_TRANSLATE_NOOP("Controls", "Envelope")},
    {EditGroup::festival, Panel::balloon, QT_TRANSLATE_NOOP("Controls", "Many balloons"), kFolded},
    {EditGroup::material, Panel::materials, QT_TRANSLATE_NOOP("Controls", "Phong coefficients")},
    {EditGroup::lens, Panel::view},
    {EditGroup::camera, Panel::view, QT_TRANSLATE_NOOP("Controls", "Camera by numbers"), kFolded},
    {EditGroup::picture, Panel::picture, QT_TRANSLATE_NOOP("Controls", "Picture")},
    {EditGroup::size, Panel::picture, QT_TRANSLATE_NOOP("Controls", "Size")},
    {EditGroup::development, Panel::picture, QT_TRANSLATE_NOOP("Controls", "Development")},
    {EditGroup::sampling, Panel::picture, QT_TRANSLATE_NOOP("Controls", "Sampling"), kFolded},
};

}  // namespace

std::span<const ControlGroup> control_groups() {
  return kGroups;
}

}  // namespace aerostat::viewer
