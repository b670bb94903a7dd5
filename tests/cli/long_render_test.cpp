// Tests renders that end early and go on: --time-limit, --save-partial and --checkpoint.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

using LongRender = CliTest;

/// A render that takes some seconds, and more with more samples.
std::vector<std::string> long_render(const std::vector<std::string>& more, int spp = 400) {
  std::vector<std::string> arguments{"--width", "320",   "--height",
                                     "180",     "--spp", std::to_string(spp)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return small_render("snow", arguments);
}

/// Returns when a file is there, or after a minute.
bool comes(const fs::path& file) {
  for (int i = 0; i < 6000 && !fs::exists(file); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return fs::exists(file);
}

TEST_F(LongRender, ATimeLimitEndsWithThePictureSoFar) {
  const auto began = std::chrono::steady_clock::now();
  const Outcome outcome = run(long_render({"--time-limit", "2s", "-o", "x.png"}, 60000));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, " of 60000 spp in the time limit of 2 s"));
  EXPECT_EQ(png_size(read_bytes(folder_ / "x.png")), (std::pair{320u, 180u}));
  EXPECT_LT(took.count(), 20.0);
  const Outcome short_one = run(small_render("snow", {"--time-limit", "0.001", "-o", "y.png"}));
  EXPECT_EQ(short_one.code, 0) << short_one.err;
  EXPECT_TRUE(fs::exists(folder_ / "y.png")) << "the first pass is always made";
  const Outcome long_one =
      run(small_render("snow", {"--time-limit", "1h", "-o", "z.png", "--spp", "2"}));
  EXPECT_TRUE(contains(long_one.err, ", 2 spp)"));
}

TEST_F(LongRender, AnInterruptSavesThePictureSoFarIfThatIsAsked) {
  // The checkpoint tells when there is a part of a picture.
  Process process(long_render({"--save-partial", "-o", "x.png", "--checkpoint", "x.ckpt",
                               "--checkpoint-every", "0.05"},
                              60000),
                  folder_, {});
  ASSERT_TRUE(comes(folder_ / "x.ckpt"));
  const auto sent = std::chrono::steady_clock::now();
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - sent;
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "interrupted; x.png shows "));
  EXPECT_EQ(png_size(read_bytes(folder_ / "x.png")), (std::pair{320u, 180u}));
  EXPECT_LT(waited.count(), 5.0);
  EXPECT_EQ(files(), (std::vector<std::string>{"x.ckpt", "x.png"}));
}

TEST_F(LongRender, GoesOnFromItsCheckpointToTheSameBytes) {
  const auto quality = [](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--set", "/image/adaptive_threshold=0.01"};
    all.insert(all.end(), more.begin(), more.end());
    return long_render(all);
  };
  const Outcome whole = run(quality({"-o", "whole.exr"}));
  ASSERT_EQ(whole.code, 0) << whole.err;
  const std::vector<std::string> parts =
      quality({"-o", "parts.exr", "--checkpoint", "x.ckpt", "--checkpoint-every", "50ms"});
  EXPECT_EQ(run(parts).code, 64) << "ms is no unit";
  const std::vector<std::string> saved =
      quality({"-o", "parts.exr", "--checkpoint", "x.ckpt", "--checkpoint-every", "0.05"});
  int ends = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGKILL, SIGINT}) {
    const auto before = fs::exists(folder_ / "x.ckpt") ? fs::last_write_time(folder_ / "x.ckpt")
                                                       : fs::file_time_type::min();
    Process process(saved, folder_, {});
    EXPECT_TRUE(comes(folder_ / "x.ckpt"));
    for (int i = 0; i < 500 && fs::exists(folder_ / "x.ckpt"); ++i) {
      std::error_code error;
      if (fs::last_write_time(folder_ / "x.ckpt", error) > before) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    process.send(signal);
    const Outcome outcome = process.wait();
    if (outcome.code == 0) break;
    ++ends;
    EXPECT_EQ(outcome.code, 128 + signal) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "parts.exr"));
    if (signal == SIGKILL) continue;
    EXPECT_TRUE(contains(outcome.err, "'x.ckpt' holds what is done"));
  }
  EXPECT_GT(ends, 0) << "the render ended before it was interrupted";
  const Outcome last = run(saved);
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_TRUE(contains(last.err, "going on from 'x.ckpt' at "));
  EXPECT_TRUE(read_bytes(folder_ / "whole.exr") == read_bytes(folder_ / "parts.exr"));
  EXPECT_EQ(files(), (std::vector<std::string>{"parts.exr", "whole.exr"}))
      << "the checkpoint is removed with the end";
}

TEST_F(LongRender, ATimeLimitWithACheckpointIsOverWith75AndGoesOn) {
  const auto sized = [](std::vector<std::string> more) {
    for (const char* word : {"--width", "160", "--height", "90", "--spp", "60"}) {
      more.emplace_back(word);
    }
    return small_render("sand", more);
  };
  const Outcome whole = run(sized({"-o", "whole.png"}));
  ASSERT_EQ(whole.code, 0) << whole.err;
  Outcome outcome;
  int times = 0;
  do {
    outcome = run(sized({"-o", "x.png", "--checkpoint", "x.ckpt", "--time-limit", "0.001s"}));
    if (outcome.code != 0) {
      EXPECT_TRUE(contains(outcome.err, "the time limit of 0 s is over; x.png shows "));
      EXPECT_TRUE(contains(outcome.err, "the same command goes on"));
    }
  } while (outcome.code == 75 && ++times < 100);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(times, 0);
  EXPECT_TRUE(read_bytes(folder_ / "whole.png") == read_bytes(folder_ / "x.png"));
}

TEST_F(LongRender, ACheckpointOfAnotherRenderIsRefusedByName) {
  const auto with = [](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--spp",        "400",    "--width",      "160",
                                 "--height",     "90",     "-o",           "x.png",
                                 "--checkpoint", "x.ckpt", "--time-limit", "0.001s"};
    all.insert(all.end(), more.begin(), more.end());
    return small_render("sand", all);
  };
  ASSERT_EQ(run(with({})).code, 75);
  const std::string older = read_bytes(folder_ / "x.ckpt");
  const struct {
    std::vector<std::string> options;
    const char* name;
  } others[] = {{{"--width", "161"}, "another size: found 160 x 90, expected 161 x 90"},
                {{"--spp", "401"}, "another quality: found 400 samples"},
                {{"--quality", "final"}, "another quality: "},
                {{"--seed", "9"}, "another seed: found 1, expected 9"},
                {{"--crop", "0,0,5,5"}, "another part of the picture: "},
                {{"--set", "/sun/elevation_deg=9"}, "another scene: "},
                {{"--lanes", "1"}, "another width of packets (--lanes): "},
                {{"-o", "x.exr"}, "another kind of output: found a picture, expected all layers"}};
  for (const auto& other : others) {
    const Outcome outcome = run(with(other.options));
    EXPECT_EQ(outcome.code, 65) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, std::string("checkpoint 'x.ckpt': it is of ") + other.name));
    EXPECT_EQ(read_bytes(folder_ / "x.ckpt"), older) << "it is left alone";
  }
  fs::copy(AEROSTAT_SOURCE_DIR "/kernels", folder_ / "kernels", fs::copy_options::recursive);
  std::string film = read_bytes(folder_ / "kernels/film.cl");
  write("kernels/film.cl", film + "\n");
  const Outcome version = run(with({}), {"AEROSTAT_KERNEL_DIR=" + (folder_ / "kernels").string()});
  EXPECT_EQ(version.code, 65) << version.err;
  EXPECT_TRUE(contains(version.err, "another version of aerostat: "));
}

TEST_F(LongRender, ADamagedCheckpointIsRefusedAndLeftAlone) {
  const auto command = small_render("sand", {"--checkpoint", "x.ckpt", "-o", "x.png"});
  for (const std::string& text : {std::string("nothing of the kind"),
                                  std::string("aerostat checkpoint 1\n") + std::string(300, 'x')}) {
    write("x.ckpt", text);
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 65) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "checkpoint 'x.ckpt'"));
    EXPECT_EQ(read_bytes(folder_ / "x.ckpt"), text);
    EXPECT_FALSE(fs::exists(folder_ / "x.png"));
  }
}

TEST_F(LongRender, MistakesAreSaidBeforeTheWork) {
  const auto code = [&](const std::vector<std::string>& more) {
    return run(small_render("sand", more)).code;
  };
  EXPECT_EQ(code({"--checkpoint", "x.png", "-o", "x.png"}), 64);
  EXPECT_EQ(code({"--checkpoint", "./x.png", "-o", "x.png"}), 64);
  EXPECT_EQ(code({"--checkpoint", scene_path("sand")}), 64);
  EXPECT_EQ(code({"--checkpoint", "/dev/null"}), 64);
  EXPECT_EQ(code({"--checkpoint", "none/x.ckpt"}), 74);
  EXPECT_EQ(code({"--checkpoint-every", "1s"}), 64);
  EXPECT_EQ(code({"--time-limit", "soon"}), 64);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace aerostat::test
