// This program renders a scene file to a PNG file:
//
//     render_to_png snow.json snow.png
#include <exception>
#include <iostream>

#include <aerostat/aerostat.hpp>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: render_to_png SCENE.json PICTURE.png\n";
    return 64;
  }
  try {
    aerostat::Session session;
    for (const aerostat::DeviceInfo& device : session.devices()) {
      std::cerr << "renders on " << device.name << '\n';
    }
    const aerostat::Scene scene = aerostat::Scene::from_file(argv[1]);
    const aerostat::Film film = session.render(scene);
    film.save(argv[2]);
    std::cerr << "wrote " << argv[2] << ", " << film.width() << " x " << film.height() << '\n';
  } catch (const aerostat::Error& error) {
    std::cerr << "render_to_png: " << error.what() << '\n';
    return error.exit_code();
  } catch (const std::exception& error) {
    std::cerr << "render_to_png: " << error.what() << '\n';
    return 70;
  }
  return 0;
}
