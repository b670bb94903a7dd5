// This program looks around from the basket. It renders four pictures with one session and shows
// progress. The first render builds the world, and the others only move the camera. A fifth
// render is cancelled while it runs.
//
//     turn_around FOLDER
#include <cstdio>
#include <iostream>
#include <stop_token>
#include <string>

#include <aerostat/aerostat.hpp>

namespace {

const char* name_of(aerostat::Stage stage) {
  switch (stage) {
    case aerostat::Stage::world:
      return "building the world";
    case aerostat::Stage::trees:
      return "building trees";
    case aerostat::Stage::kernels:
      return "compiling kernels";
    case aerostat::Stage::upload:
      return "copying to the device";
    case aerostat::Stage::rays:
      return "tracing rays";
    case aerostat::Stage::done:
      return "done";
  }
  return "";
}

void show(const aerostat::Progress& progress) {
  std::fprintf(stderr, "\r%-24s %3.0f %%", name_of(progress.stage), 100.0 * progress.fraction);
}

int run(const std::string& folder) {
  aerostat::SessionOptions options;
  options.interactive = true;
  aerostat::Session session(options);

  aerostat::Scene scene = aerostat::Scene::from_json(R"({
    "version": 1, "biome": "snow", "quality": "draft", "image": {"width": 320, "height": 180},
    "balloon": {"enabled": false},
    "camera": {"position": [0, 300, 0], "target": [0, 250, -1000]}
  })");
  const char* targets[] = {"[0, 250, -1000]", "[1000, 250, 0]", "[0, 250, 1000]",
                           "[-1000, 250, 0]"};
  const char* names[] = {"north", "east", "south", "west"};
  for (int i = 0; i < 4; ++i) {
    const aerostat::Scene view = scene.with("/camera/target", targets[i]);
    session.render(view, show).save(folder + "/" + names[i] + ".png");
    std::fprintf(stderr, "\rwrote %s.png%30s\n", names[i], "");
  }

  std::stop_source stop;
  try {
    const aerostat::Scene slow = scene.with("/image/spp", "64");
    session.render(
        slow,
        [&stop](const aerostat::Progress& progress) {
          if (progress.stage == aerostat::Stage::rays) stop.request_stop();
        },
        stop.get_token());
  } catch (const aerostat::Error& error) {
    if (error.kind() != aerostat::ErrorKind::interrupted) throw;
    std::fprintf(stderr, "the fifth picture was cancelled\n");
    return 0;
  }
  std::fprintf(stderr, "the fifth picture was not cancelled\n");
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: turn_around FOLDER\n";
    return 64;
  }
  try {
    return run(argv[1]);
  } catch (const aerostat::Error& error) {
    std::cerr << "turn_around: " << error.what() << '\n';
    return error.exit_code();
  }
}
