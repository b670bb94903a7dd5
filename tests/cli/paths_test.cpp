// Tests that a scene file names files outside of its folder only if that is allowed.

#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

class Paths : public CliTest {
 protected:
  /// Writes a scene whose model has this name, and a model beside it and below it.
  void put(const std::string& name) const {
    fs::create_directories(folder_ / "scenes/models");
    for (const char* model : {"one.obj", "scenes/one.obj", "scenes/models/one.obj"}) {
      write(model, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    write("scenes/a.json", R"({"version": 1, "biome": "sand", "terrain": {"cells": 64},
                               "objects": [{"file": ")" +
                               name + R"(", "position": [0, 0, 0]}]})");
  }

  Outcome check(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"check", "scenes/a.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(Paths, BelowTheSceneAreTaken) {
  for (const char* name : {"one.obj", "models/one.obj", "./models/../one.obj"}) {
    put(name);
    EXPECT_EQ(check().code, 0) << name << "\n" << check().err;
  }
}

TEST_F(Paths, OutsideOfItsFolderNeedLeave) {
  for (const std::string& name :
       {std::string("../one.obj"), std::string("models/../../one.obj"),
        (folder_ / "scenes/one.obj").string(), (folder_ / "one.obj").string()}) {
    put(name);
    const Outcome refused = check();
    EXPECT_EQ(refused.code, 65) << name;
    EXPECT_TRUE(contains(refused.err, "/objects/0/file: found \"" + name +
                                          "\", expected a file in the folder of the scene"));
    EXPECT_TRUE(contains(refused.err, "--allow-external-paths"));
    EXPECT_EQ(check({"--allow-external-paths"}).code, 0) << check({"--allow-external-paths"}).err;
  }
}

TEST_F(Paths, OfAllKindsAreToldAtOnce) {
  write("a.json", R"({"version": 1, "terrain": {"source": ["/a.tif", "b.tif", "../c.tif"],
      "drape": {"file": "/d.tif"}, "cover": {"source": "../e.tif"}},
      "balloon": {"track": {"file": "/f.igc"}, "artwork": [{"file": "/k.png"}]}, "balloons": [{"track": {"file": "../g.igc"}}],
      "objects": [{"file": "h.obj", "position": [0, 0, 0]},
                  {"file": "/i.obj", "position": [0, 0, 0]}], "sun": {"elevation_deg": 95}})");
  const Outcome outcome = run({"check", "a.json"});
  EXPECT_EQ(outcome.code, 65);
  for (const char* pointer :
       {"/terrain/source/0: ", "/terrain/source/2: ", "/terrain/drape/file: ",
        "/terrain/cover/source: ", "/balloon/track/file: ", "/balloon/artwork/0/file: ",
        "/balloons/0/track/file: ", "/objects/1/file: ", "/sun/elevation_deg: "}) {
    EXPECT_TRUE(contains(outcome.err, pointer));
  }
}

TEST_F(Paths, OfTheCommandLineMayBeAny) {
  put("one.obj");
  const std::string outside = "/objects/0/file=" + (folder_ / "one.obj").string();
  EXPECT_EQ(check({"--set", outside}).code, 0) << check({"--set", outside}).err;
}

}  // namespace
}  // namespace aerostat::test
