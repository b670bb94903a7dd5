// Tests films: frames that are kept, made anew and shared, and a film by a script in place of
// ffmpeg.

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

class Film : public CliTest {
 protected:
  /// Returns arguments that make a film of six tiny frames.
  static std::vector<std::string> small_film(const std::string& output,
                                             const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"film", scene_path("sand"), "-o", output};
    for (const char* change :
         {"/terrain/cells=32", "/vegetation/enabled=false", "/image/width=32", "/image/height=18",
          "/image/spp=1", "/film/duration_s=0.6", "/film/fps=10", "/film/meter_s=0.4"}) {
      arguments.insert(arguments.end(), {"--set", change});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  std::string frame(const std::string& folder, int number) const {
    return read_bytes(folder_ / folder / (std::to_string(number) + ".png"));
  }

  fs::file_time_type time_of(const std::string& name) const {
    return fs::last_write_time(folder_ / name);
  }

  /// Makes a script in place of ffmpeg, and returns the environment in which it is found.
  Environment with_ffmpeg(const std::string& body) const {
    fs::create_directory(folder_ / "bin");
    const fs::path script = folder_ / "bin" / "ffmpeg";
    std::ofstream(script) << "#!/bin/sh\n" << body << "\n";
    fs::permissions(script, fs::perms::owner_all);
    return {"PATH=" + (folder_ / "bin").string() + ":/usr/bin:/bin"};
  }
};

/// A script that writes its input to the file that its last argument names, and its arguments to a
/// file beside it.
constexpr const char* kCopy = "for a; do last=$a; done; echo \"$@\" > arguments; cat > \"$last\"";

TEST_F(Film, FramesAreTheSameAloneInOrderAndInShards) {
  ASSERT_EQ(run(small_film("all/#.png")).code, 0);
  for (const char* shard : {"3/4", "1/4", "4/4", "2/4"}) {
    ASSERT_EQ(run(small_film("parts/#.png", {"--shard", shard})).code, 0);
  }
  ASSERT_EQ(run(small_film("alone/#.png", {"--frames", "5"})).code, 0);
  for (int number = 1; number <= 6; ++number) {
    EXPECT_EQ(png_size(frame("all", number)), (std::pair{32u, 18u}));
    EXPECT_EQ(frame("parts", number), frame("all", number)) << number;
  }
  EXPECT_EQ(frame("alone", 5), frame("all", 5));
  EXPECT_NE(frame("all", 1), frame("all", 6));
  EXPECT_TRUE(fs::exists(folder_ / "all/contact-sheet.png"));
  EXPECT_FALSE(fs::exists(folder_ / "alone/6.png"));
}

TEST_F(Film, BlurredFramesAreTheSameAloneInOrderAndInShards) {
  const std::vector<std::string> open{"--set", "/film/shutter_angle_deg=180", "--set",
                                      "/film/shutter_moments=3"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), open.begin(), open.end());
    return more;
  };
  ASSERT_EQ(run(small_film("closed/#.png")).code, 0);
  ASSERT_EQ(run(small_film("all/#.png", open)).code, 0);
  for (const char* shard : {"2/2", "1/2"}) {
    ASSERT_EQ(run(small_film("parts/#.png", with({"--shard", shard}))).code, 0);
  }
  const Outcome stopped = run(small_film("resumed/#.png", with({"--time-limit", "0.001s"})));
  EXPECT_EQ(stopped.code, 75);
  ASSERT_EQ(run(small_film("resumed/#.png", open)).code, 0);
  for (int number = 1; number <= 6; ++number) {
    EXPECT_EQ(frame("parts", number), frame("all", number)) << number;
    EXPECT_EQ(frame("resumed", number), frame("all", number)) << number;
    EXPECT_NE(frame("closed", number), frame("all", number)) << number;
  }
  // The angle 0 makes the frames of a film that says nothing of a shutter.
  const Outcome kept = run(small_film("closed/#.png", {"--set", "/film/shutter_angle_deg=0"}));
  EXPECT_TRUE(contains(kept.err, "0 rendered, 6 kept")) << kept.err;
}

TEST_F(Film, FramesAreKeptUnlessTheyAreOfAnotherScene) {
  ASSERT_EQ(run(small_film("f/#.png")).code, 0);
  const std::string second = frame("f", 2), third = frame("f", 3);
  const auto first_time = time_of("f/1.png"), second_time = time_of("f/2.png");
  ASSERT_EQ(run({"render", scene_path("sand"), "--set", "/terrain/cells=32", "--set",
                 "/vegetation/enabled=false", "--width", "32", "--height", "18", "--spp", "1", "-o",
                 "f/2.png"})
                .code,
            0);
  std::ofstream(folder_ / "f/3.png") << third.substr(0, third.size() / 2);
  fs::remove(folder_ / "f/4.png");

  const Outcome bad = run(small_film("f/#.png", {"--verify"}));
  EXPECT_EQ(bad.code, 65);
  EXPECT_EQ(bad.out, "foreign 2 f/2.png\nbroken 3 f/3.png\nmissing 4 f/4.png\n");

  const Outcome again = run(small_film("f/#.png"));
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "6 frames: 3 rendered, 3 kept"));
  EXPECT_TRUE(contains(again.err, "1 frames were made from another scene"));
  EXPECT_TRUE(contains(again.err, "1 files of frames are damaged"));
  EXPECT_EQ(time_of("f/1.png"), first_time);
  EXPECT_NE(time_of("f/2.png"), second_time);
  EXPECT_EQ(frame("f", 2), second);
  EXPECT_EQ(frame("f", 3), third);

  const Outcome good = run(small_film("f/#.png", {"--verify"}));
  EXPECT_EQ(good.code, 0);
  EXPECT_EQ(good.out, "");
  // Another sun makes all frames foreign.
  EXPECT_EQ(run(small_film("f/#.png", {"--verify", "--set", "/sun/elevation_deg=31"})).code, 65);
}

TEST_F(Film, FramesOfOtherKernelsAreForeign) {
  ASSERT_EQ(run(small_film("f/#.png")).code, 0);
  fs::copy(AEROSTAT_SOURCE_DIR "/kernels", folder_ / "kernels", fs::copy_options::recursive);
  const Environment other{"AEROSTAT_KERNEL_DIR=" + (folder_ / "kernels").string()};
  EXPECT_EQ(run(small_film("f/#.png", {"--verify"}), other).code, 0);
  std::ofstream(folder_ / "kernels/device/material/cloth.clh", std::ios::app) << "// changed\n";
  const Outcome changed = run(small_film("f/#.png", {"--verify"}), other);
  EXPECT_EQ(changed.code, 65);
  EXPECT_TRUE(contains(changed.out, "foreign 6 f/6.png")) << changed.out;
}

TEST_F(Film, StopsAtItsTimeLimitAndGoesOn) {
  const Outcome stopped = run(small_film("f/#.png", {"--time-limit", "0.001s"}));
  EXPECT_EQ(stopped.code, 75);
  EXPECT_TRUE(contains(stopped.err, "1 frames made and 5 left"));
  ASSERT_EQ(run(small_film("f/#.png", {"--time-limit", "10m"})).code, 0);
}

TEST_F(Film, WhatIsKilledLeavesWholeFramesOnly) {
  Process process(small_film("f/#.png", {"--set", "/film/duration_s=60"}), folder_, {});
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!fs::exists(folder_ / "f/2.png") && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  process.send(SIGKILL);
  process.wait();
  const Outcome outcome = run(small_film("f/#.png", {"--set", "/film/duration_s=60", "--verify"}));
  EXPECT_TRUE(contains(outcome.err, "0 broken, 0 foreign"));
  EXPECT_FALSE(contains(outcome.err, "0 of 600 frames are there"));
}

TEST_F(Film, FilmsAreEncodedFromTheirFrames) {
  const Environment environment = with_ffmpeg(kCopy);
  const Outcome outcome = run(small_film("x.mp4"), environment);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(files(),
            (std::vector<std::string>{"arguments", "bin", "x-sheet.png", "x.frames", "x.mp4"}));
  // Six frames of 32 x 18 pixels of three bytes.
  EXPECT_EQ(read_bytes(folder_ / "x.mp4").size(), 6u * 32u * 18u * 3u);
  const std::string arguments = read_bytes(folder_ / "arguments");
  EXPECT_TRUE(contains(arguments, "-video_size 32x18 -framerate 10 "));
  EXPECT_TRUE(contains(arguments, "-c:v libx264"));
  EXPECT_TRUE(contains(arguments, "out_range=tv"));
  EXPECT_TRUE(contains(arguments, "-colorspace bt709 -color_range tv"));
  // The frames are kept, and the film is the same.
  const std::string film = read_bytes(folder_ / "x.mp4");
  const Outcome again = run(small_film("x.mp4"), environment);
  EXPECT_TRUE(contains(again.err, "0 rendered, 6 kept"));
  EXPECT_EQ(read_bytes(folder_ / "x.mp4"), film);
}

/// Returns what ffprobe tells of a film: codec, tags of colours, rate, and the frames that it has.
std::string probed(const fs::path& film) {
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v -show_entries "
      "stream=codec_name,color_range,"
      "color_space,color_primaries,color_transfer,r_frame_rate,nb_read_frames -of csv=p=0 '" +
      film.string() + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::array<char, 256> line{};
  const bool is_read =
      std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) != nullptr;
  return is_read ? line.data() : "";
}

TEST_F(Film, FilmsOfTheRealFfmpegTellTheirColours) {
  if (!fs::exists("/usr/bin/ffmpeg") || !fs::exists("/usr/bin/ffprobe")) {
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  const std::string tags = ",tv,bt709,bt709,bt709,10/1,6\n";
  const std::tuple<const char*, const char*, std::string> films[] = {
      {"h264", "a.mp4", "h264" + tags},
      {"av1", "b.webm", "av1" + tags},
      {"prores", "c.mov", "prores" + tags},
      {"lossless", "d.mkv", "ffv1,pc,gbr,bt709,bt709,10/1,6\n"}};
  for (const auto& [codec, name, expected] : films) {
    const Outcome outcome =
        run(small_film(name, {"--codec", codec, "--width", "64", "--height", "64"}));
    // Distributions build ffmpeg with different encoders.
    if (contains(outcome.err, "Unknown encoder")) continue;
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(probed(folder_ / name), expected) << codec;
  }
}

TEST_F(Film, WithoutFfmpegTheFramesAreMade) {
  fs::create_directory(folder_ / "empty");
  const Outcome outcome = run(small_film("x.mp4"), {"PATH=" + (folder_ / "empty").string()});
  EXPECT_EQ(outcome.code, 69);
  EXPECT_TRUE(contains(outcome.err, "apt install ffmpeg"));
  EXPECT_TRUE(fs::exists(folder_ / "x.frames/00006.png"));
  EXPECT_FALSE(fs::exists(folder_ / "x.mp4"));
}

TEST_F(Film, WordsOfFfmpegAreTold) {
  std::ofstream(folder_ / "x.mp4") << "older";
  const Outcome outcome =
      run(small_film("x.mp4"), with_ffmpeg("echo 'Unknown encoder libx264' >&2; exit 3"));
  EXPECT_EQ(outcome.code, 74);
  EXPECT_TRUE(contains(outcome.err, "exit code 3"));
  EXPECT_TRUE(contains(outcome.err, "Unknown encoder libx264"));
  EXPECT_EQ(read_bytes(folder_ / "x.mp4"), "older");
  EXPECT_TRUE(fs::exists(folder_ / "x.frames/00006.png"));
}

TEST_F(Film, MistakesAreOneClearLineAndCode64) {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"-o", "x.gif"}, "'x.gif'"},
      {{"-o", "frame.png"}, "one run of #"},
      {{"-o", "-"}, "--output"},
      {{"--frames", "7"}, "--frames: the film has 6 frames"},
      {{"--frames", "a"}, "--frames: found 'a'"},
      {{"--shard", "5/4"}, "--shard: found '5/4'"},
      {{"--time-limit", "soon"}, "--time-limit: 'soon'"},
      {{"--codec", "vp9"}, "--codec: vp9"},
      {{"--codec", "prores"}, "prores goes into .mov, .mkv"},
      {{"--width", "31"}, "even sides"},
      {{"--codec", "av1"}, "av1 needs sides of 64 pixels or more, found 32 x 18"},
  };
  for (const auto& [arguments, part] : mistakes) {
    const Outcome outcome = run(small_film("x.mp4", arguments));
    EXPECT_EQ(outcome.code, 64) << part;
    EXPECT_TRUE(contains(outcome.err, part));
    EXPECT_EQ(files(), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace aerostat::test
