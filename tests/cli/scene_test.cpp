// Tests good and bad scenes, and the commands that only read them.

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using Scenes = CliTest;

constexpr const char* kScenes[] = {
    "snow",       "snow-basket", "tropical",  "tropical-basket", "sand",      "sand-basket",
    "sand-empty", "valley-fog",  "alpenglow", "night-glow",      "storm",     "autumn",
    "lake",       "canyon",      "festival",  "raetikon",        "st-helens", "grand-canyon",
    "swallows",   "flight",      "whale",     "descent",         "launch",    "village"};

TEST_F(Scenes, AllAreGood) {
  for (const char* scene : kScenes) {
    const Outcome outcome = run({"check", scene_path(scene)});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    // Only elevation data and films have a report.
    EXPECT_TRUE(outcome.out.empty() || contains(outcome.out, ": land from a file\n") ||
                contains(outcome.out, "film: "));
  }
}

TEST_F(Scenes, ADumpOfADumpIsTheSame) {
  for (const char* scene : kScenes) {
    const Outcome first = run({"dump", scene_path(scene)});
    ASSERT_EQ(first.code, 0) << first.err;
    // Only what files of real land left to be guessed or mended is said.
    const bool real = contains(first.out, "\"kind\": \"elevation\"");
    EXPECT_TRUE(real || first.err.empty()) << first.err;
    // A dump names files by absolute paths.
    const Outcome second = run({"dump", write("dump.json", first.out), "--allow-external-paths"});
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(second.out, first.out) << scene;
  }
}

TEST_F(Scenes, ADumpHasWhatOtherProgramsNeed) {
  const auto json = nlohmann::json::parse(run({"dump", scene_path("snow-basket")}).out);
  for (const char* key : {"position", "target", "up"}) {
    EXPECT_EQ(json.at("camera").at(key).size(), 3u) << key;
  }
  EXPECT_GT(json.at("camera").at("fov_y_deg").get<double>(), 0.0);
  const auto sun = json.at("sun").at("direction").get<std::vector<double>>();
  EXPECT_NEAR(std::hypot(sun.at(0), sun.at(1), sun.at(2)), 1.0, 1e-9);
  EXPECT_GE(json.at("image").at("width").get<int>(), 1);
  EXPECT_GE(json.at("image").at("height").get<int>(), 1);
}

TEST_F(Scenes, SetChangesTheScene) {
  const Outcome outcome = run({"dump", scene_path("snow"), "--set", "/image/width=77", "--set",
                               "/terrain/seed=5", "--set", "/terrain/seed=6"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("image").at("width"), 77);
  EXPECT_EQ(json.at("terrain").at("seed"), 6);
}

/// Tests waves of the ground that are so short that an integer cannot hold their number across the
/// land.
TEST_F(Scenes, TheFinestFractalsAreNumbers) {
  const std::string scenes[] = {
      R"({"version": 1, "biome": "snow", "terrain": {"cells": 48, "fractal": {"octaves": 17, "lacunarity": 4}},
          "vegetation": {"enabled": false}, "balloon": {"position": [5000, 420, 5000]}})",
      R"({"version": 1, "terrain": {"cells": 48, "center": [50000, 50000],
          "fractal": {"octaves": 20, "lacunarity": 3}}, "vegetation": {"enabled": false}})"};
  for (const std::string& scene : scenes) {
    const Outcome dump = run({"dump", write("fine.json", scene)});
    EXPECT_EQ(dump.code, 0) << dump.err;
    EXPECT_EQ(dump.out.find("nan"), std::string::npos);
    EXPECT_EQ(run({"dump", write("dump.json", dump.out)}).out, dump.out);
    const Outcome picture =
        run({"render", "fine.json", "--width", "32", "--height", "18", "--spp", "1"});
    EXPECT_EQ(picture.code, 0) << picture.err;
  }
}

TEST_F(Scenes, ACameraMayLookStraightDown) {
  const std::string down = R"({"version": 1, "camera": {"position": [0, 300, 0], "target": [0, )";
  EXPECT_EQ(run({"check", write("down.json", down + "9, 0]}}")}).code, 0);
  const Outcome same = run({"check", write("same.json", down + "300, 0]}}")});
  EXPECT_EQ(same.code, 65);
  EXPECT_TRUE(contains(same.err, "/camera/target: found the camera's own position"));
}

/// Returns the environment in which the repository's scenes are the installed ones.
Environment with_scenes() {
  return {"AEROSTAT_SCENE_DIR=" + std::filesystem::path(scene_path("")).parent_path().string()};
}

TEST_F(Scenes, InstalledOnesGoByTheirNames) {
  const Outcome by_name = run({"dump", "sand-empty"}, with_scenes());
  ASSERT_EQ(by_name.code, 0) << by_name.err;
  EXPECT_EQ(by_name.out, run({"dump", scene_path("sand-empty")}).out);
  // A file of the name has priority. A folder or an extension makes the name a path.
  write("snow", R"({"version": 1, "image": {"width": 77}})");
  EXPECT_TRUE(contains(run({"dump", "snow"}, with_scenes()).out, "\"width\": 77"));
  for (const char* path : {"snow.json", "./sand", "nothing", "aerostat-scene.schema"}) {
    const Outcome outcome = run({"check", path}, with_scenes());
    EXPECT_EQ(outcome.code, 74) << path;
    EXPECT_TRUE(contains(outcome.err, std::string(path) + ": cannot read the scene"));
  }
}

TEST_F(Scenes, InstalledOnesAreListed) {
  const Outcome list = run({"scenes"}, with_scenes());
  ASSERT_EQ(list.code, 0) << list.err;
  for (const char* scene : kScenes) EXPECT_TRUE(contains(list.out, std::string(scene) + " "));
  EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '\n'), 24);
  EXPECT_TRUE(contains(list.out, "without a balloon"));
  EXPECT_EQ(run({"scenes", "--folder"}, {"AEROSTAT_SCENE_DIR=/some/where"}).out, "/some/where\n");
  const Outcome none = run({"scenes"}, {"AEROSTAT_SCENE_DIR=" + folder_.string()});
  EXPECT_EQ(none.code, 74);
  EXPECT_TRUE(contains(none.err, folder_.string()));
}

struct Fault {
  std::string text;
  std::string pointer;
};

TEST_F(Scenes, BadOnesNameFileAndPointer) {
  const Fault faults[] = {
      {R"({"version": 1, "biome": "snow", "bogus": 1})", "/bogus"},
      {R"({"version": 1, "biome": "snow", "image": {"width": -4}})", "/image/width"},
      {R"({"version": 1, "biome": "snow", "terrain": {"cells": "many"}})", "/terrain/cells"},
      {R"({"version": 1, "biome": "moon"})", "/biome"},
      {R"({"version": 2, "biome": "snow"})", "/version"},
      {R"({"version": 1, "biome": )", "bad.json"},
      {"", "bad.json"},
  };
  for (const Fault& fault : faults) {
    const std::string scene = write("bad.json", fault.text);
    for (const char* command : {"check", "dump", "render"}) {
      const Outcome outcome = run({command, scene});
      EXPECT_EQ(outcome.code, 65) << outcome.err;
      EXPECT_EQ(outcome.out, "");
      EXPECT_TRUE(contains(outcome.err, "bad.json"));
      EXPECT_TRUE(contains(outcome.err, fault.pointer));
    }
  }
  EXPECT_EQ(files(), std::vector<std::string>{"bad.json"});
}

TEST_F(Scenes, ABadSetIsABadScene) {
  const Outcome outcome = run({"check", scene_path("snow"), "--set", "/image/width=-4"});
  EXPECT_EQ(outcome.code, 65);
  EXPECT_TRUE(contains(outcome.err, "/image/width"));
}

TEST_F(Scenes, MissingOnesAreNamed) {
  for (const std::string command : {"check", "dump", "render"}) {
    const Outcome outcome = run({command, "missing.json"});
    EXPECT_EQ(outcome.code, 74) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(contains(outcome.err, "missing.json"));
  }
  EXPECT_EQ(run({"check", "."}).code, 65);  // a folder could hold elevation data
  EXPECT_TRUE(files().empty());
}

std::size_t header_count(const std::string& ply, const std::string& element) {
  const auto at = ply.find("element " + element + " ");
  return at == std::string::npos ? 0 : std::stoull(ply.substr(at + element.size() + 9));
}

TEST_F(Scenes, TheWorldIsExported) {
  const std::vector<std::string> small{"--set", "/terrain/cells=16", "--plants", "none"};
  std::vector<std::string> arguments{"export", scene_path("snow"), "-o", "world.ply"};
  arguments.insert(arguments.end(), small.begin(), small.end());
  const Outcome ply = run(arguments);
  ASSERT_EQ(ply.code, 0) << ply.err;
  EXPECT_EQ(ply.out, "");
  const std::string bytes = read_bytes(folder_ / "world.ply");
  EXPECT_EQ(bytes.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0u);
  EXPECT_GT(header_count(bytes, "vertex"), 0u);
  EXPECT_GE(header_count(bytes, "face"), 2u * 16u * 16u);
  EXPECT_TRUE(contains(bytes.substr(0, 600), "object_id"));
  arguments[3] = "world.obj";
  ASSERT_EQ(run(arguments).code, 0);
  const std::string text = read_bytes(folder_ / "world.obj");
  for (const char* line :
       {"\nmtllib world.mtl\n", "\no ", "\nusemtl terrain\n", "\nv ", "\nvn ", "\nf "}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"world.mtl", "world.obj", "world.ply"}));
}

TEST_F(Scenes, AnExportHasItsMaterialsBesideIt) {
  const Outcome outcome =
      run({"export", scene_path("snow"), "-o", "world.obj", "--set", "/terrain/cells=16",
           "--plants", "none", "--set", "/materials/terrain/albedo=[0.5, 0.25, 0.125]"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string library = read_bytes(folder_ / "world.mtl");
  EXPECT_TRUE(contains(library, "newmtl terrain\nKd 0.5 0.25 0.125\n")) << library;
  EXPECT_TRUE(contains(library, "newmtl envelope\nKd "));
}

TEST_F(Scenes, AnExportHasThePlantsThatAreAskedFor) {
  const auto faces_with = [&](const std::string& plants) {
    const Outcome outcome =
        run({"export", scene_path("snow"), "-o", plants + ".ply", "--plants", plants, "--set",
             "/terrain/cells=64", "--set", "/vegetation/density=0.01"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return header_count(read_bytes(folder_ / (plants + ".ply")), "face");
  };
  const std::size_t none = faces_with("none"), seen = faces_with("seen"), all = faces_with("all");
  EXPECT_LT(none, seen);
  EXPECT_LT(seen, all);
}

TEST_F(Scenes, AnExportThatIsTooLargeIsRefused) {
  const Outcome outcome =
      run({"export", scene_path("sand-empty"), "-o", "world.ply", "--set", "/terrain/cells=32",
           "--most-triangles", "2047", "--plants", "none"});
  EXPECT_EQ(outcome.code, 75);
  EXPECT_TRUE(contains(outcome.err, "2048 triangles")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "--most-triangles")) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "world.ply"));
}

TEST_F(Scenes, TheViewForAnotherRendererIsPrinted) {
  const Outcome outcome =
      run({"dump", scene_path("sand-empty"), "--view", "--set", "/camera/position=[0, 500, 0]",
           "--set", "/camera/target=[0, 500, -10]", "--set", "/camera/fov_y_deg=90", "--set",
           "/image/width=200", "--set", "/image/height=100", "--set", "/sky/radiance=[1, 2, 3]",
           "--set", "/sun/irradiance=4", "--set", "/camera/height_above=sea"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* line :
       {"\"origin\": [0, 0, 0]", "\"position\": [0, 500, 0]", "\"right\": [1, 0, 0]",
        "\"up\": [0, 1, 0]", "\"forward\": [0, 0, -1]", "\"fov_y_deg\": 90",
        "\"fov_x_deg\": 126.86989", "\"radiance\": [1, 2, 3]"}) {
    EXPECT_TRUE(contains(outcome.out, line)) << line << " in " << outcome.out;
  }
}

TEST_F(Scenes, AFarWorldIsExportedAsTheNearOneWithItsOrigin) {
  const std::string scene = scene_path("sand-empty");
  const auto exported = [&](const std::string& name, const std::string& center) {
    const Outcome outcome = run({"export", scene, "-o", name, "--set", "/terrain/cells=16", "--set",
                                 "/terrain/center=" + center, "--plants", "none"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_bytes(folder_ / name);
  };
  const std::string near = exported("near.obj", "[0, 0]");
  std::string far = exported("far.obj", "[1000000, -1000000]");
  const std::string comment = "# origin 1000000 0 -1000000\n";
  const auto at = far.find(comment);
  ASSERT_NE(at, std::string::npos);
  far.erase(at, comment.size());
  const auto library = far.find("mtllib far.mtl");
  ASSERT_NE(library, std::string::npos);
  far.replace(library, 14, "mtllib near.mtl");
  EXPECT_TRUE(far == near);
}

TEST_F(Scenes, AnExportThatDoesNotArriveIsAnError) {
  std::filesystem::create_symlink("/dev/full", folder_ / "full.ply");
  const Outcome outcome =
      run({"export", scene_path("sand-empty"), "-o", "full.ply", "--set", "/terrain/cells=4"});
  EXPECT_EQ(outcome.code, 74);
  EXPECT_TRUE(contains(outcome.err, "full.ply"));
}

}  // namespace
}  // namespace aerostat::test
