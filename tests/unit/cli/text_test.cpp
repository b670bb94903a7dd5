// Tests the parts of the command line that are plain functions.

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/help_layout.hpp"
#include "cli/interrupt.hpp"
#include "cli/parse.hpp"
#include "cli/progress_bar.hpp"
#include "cli/progress_text.hpp"
#include "cli/report.hpp"
#include "core/error.hpp"
#include "core/grouped.hpp"

namespace aerostat::cli {
namespace {

using render::Progress;
using render::Stage;

TEST(Crop, IsParsed) {
  const render::Crop crop = parse_crop("1,2,30,40");
  EXPECT_EQ(crop.x0, 1);
  EXPECT_EQ(crop.y0, 2);
  EXPECT_EQ(crop.x1, 30);
  EXPECT_EQ(crop.y1, 40);
  for (const char* text :
       {"", "1", "1,2,3", "1,2,3,", "1,2,3,4,", "1,2,3,4,5", "a,b,c,d", "1;2;3;4", " 1,2,3,4",
        "-1,0,3,4", "3,2,3,4", "1,4,3,4", "0,0,99999999999,4"}) {
    EXPECT_THROW(parse_crop(text), Error) << text;
  }
  EXPECT_NO_THROW(require_inside(crop, 30, 40));
  EXPECT_THROW(require_inside(crop, 29, 40), Error);
  EXPECT_THROW(require_inside(crop, 30, 39), Error);
}

TEST(Seeds, AreParsed) {
  using Seeds = std::vector<std::uint32_t>;
  EXPECT_EQ(parse_seeds("7"), Seeds{7});
  EXPECT_EQ(parse_seeds("1-4"), (Seeds{1, 2, 3, 4}));
  EXPECT_EQ(parse_seeds("1,5,9-11"), (Seeds{1, 5, 9, 10, 11}));
  EXPECT_EQ(parse_seeds("5,5,2-2"), (Seeds{5, 5, 2}));
  EXPECT_EQ(parse_seeds("4294967294-4294967295"), (Seeds{4294967294u, 4294967295u}));
  EXPECT_EQ(parse_seeds("1-1000").size(), 1000u);
  for (const char* text : {"", ",", "1,", ",1", "-1", "1-", "-", "1--2", "2-1", "a", "1.5", " 1",
                           "1 - 2", "4294967296", "1-4294967295", "1-1000,1"}) {
    EXPECT_THROW(parse_seeds(text), Error) << text;
  }
}

TEST(ByteSize, IsParsed) {
  EXPECT_EQ(parse_byte_size("1500"), 1500u);
  EXPECT_EQ(parse_byte_size("4k"), 4096u);
  EXPECT_EQ(parse_byte_size("1.5GiB"), 1610612736u);
  EXPECT_EQ(parse_byte_size("2MB"), 2097152u);
  EXPECT_EQ(parse_byte_size("1T"), 1099511627776u);
  for (const char* text : {"", "G", "-1", "0", "nan", "inf", "1X", "1 G", "1Gi", "1e30", "1kk",
                           "1.5", "1.5B", "0.9"}) {
    EXPECT_THROW(parse_byte_size(text), Error) << text;
  }
}

TEST(Formats, FollowTheExtension) {
  EXPECT_EQ(picture_format("a.png"), PictureFormat::png);
  EXPECT_EQ(picture_format("dir.exr/a.PNG"), PictureFormat::png);
  EXPECT_EQ(picture_format("a.b.exr"), PictureFormat::exr);
  EXPECT_EQ(mesh_format("w.Ply"), MeshFormat::ply);
  EXPECT_EQ(mesh_format("w.obj"), MeshFormat::obj);
  for (const char* name : {"", "png", ".png", "a.jpg", "a.png.gz", "a."}) {
    EXPECT_THROW(picture_format(name), Error) << name;
  }
  EXPECT_EQ(default_picture("some/where/snow.json"), "snow.png");
  EXPECT_EQ(default_picture("some/where/snow.json", "-seeds.png"), "snow-seeds.png");
}

TEST(HelpLayout, BreaksAtWords) {
  EXPECT_EQ(wrapped("one two three\n", 8), "one two\nthree\n");
  EXPECT_EQ(wrapped("  one two three\n", 10), "  one two\n  three\n");
  EXPECT_EQ(wrapped("  -o  one two three\n", 14), "  -o  one two\n      three\n");
  EXPECT_EQ(wrapped("toolongaword two\n", 5), "toolongaword\ntwo\n");
  EXPECT_EQ(wrapped("Examples:\n  run a b c d e f\n\nOther: a b\n", 12),
            "Examples:\n  run a b \\\n      c d \\\n      e f\n\nOther: a b\n");
  const std::string fits = "  --a N     short\n\nend\n";
  EXPECT_EQ(wrapped(fits, 40), fits);
}

TEST(Formats, AreSaidOrFollow) {
  EXPECT_EQ(picture_format("-"), PictureFormat::png);
  EXPECT_EQ(picture_format("-", "exr"), PictureFormat::exr);
  EXPECT_EQ(picture_format("a.png", "exr"), PictureFormat::exr);
  EXPECT_EQ(mesh_format("-"), MeshFormat::ply);
  EXPECT_EQ(mesh_format("a", "obj"), MeshFormat::obj);
  EXPECT_THROW(default_picture("-"), Error);
}

TEST(Duration, IsReadable) {
  EXPECT_EQ(duration_text(0.2), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1:00");
  EXPECT_EQ(duration_text(185.0), "3:05");
  EXPECT_EQ(duration_text(3723.0), "1:02:03");
}

TEST(Grouped, SeparatesThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

const ProgressView kView{Stage::rays, 0.475, 12.34e6, 8.0, ""};

TEST(TerminalLine, FitsAnyWidth) {
  for (int columns = 0; columns < 200; ++columns) {
    const std::string line = terminal_line(kView, columns, false);
    EXPECT_LE(static_cast<int>(line.size()), std::max(columns - 1, 0)) << line;
  }
}

TEST(TerminalLine, SaysWhatFits) {
  EXPECT_EQ(terminal_line(kView, 66, false),
            "tracing rays [#########-----------]  47 %  12.3 Mrays/s  8 s left");
  EXPECT_EQ(terminal_line(kView, 46, false), "tracing rays  47 %  12.3 Mrays/s  8 s left");
  EXPECT_EQ(terminal_line(kView, 40, false), "tracing rays [###-----]  47 %  8 s left");
  EXPECT_EQ(terminal_line(kView, 20, false), "tracing rays  47 %");
  EXPECT_EQ(plain_line(kView), "tracing rays   47 %  12.3 Mrays/s  8 s left");
}

TEST(TerminalLine, ALabelStandsForTheStage) {
  ProgressView view = kView;
  view.label = "seed 3, 2 of 12";
  EXPECT_EQ(terminal_line(view, 30, false), "seed 3, 2 of 12  47 %");
  EXPECT_EQ(plain_line(view), "seed 3, 2 of 12   47 %  12.3 Mrays/s  8 s left");
}

TEST(TerminalLine, TellsThatKernelsAreCompiledAndForHowLong) {
  ProgressView view{Stage::kernels, 0.375, 0.0, std::nullopt, "", 6.2};
  EXPECT_EQ(plain_line(view), "compiling kernels (first run only)   37 %  6 s so far");
  EXPECT_EQ(terminal_line(view, 72, false),
            "compiling kernels (first run only) [######----------]  37 %  6 s so far");
  view.stage_seconds = 0.3;
  EXPECT_EQ(plain_line(view), "compiling kernels   37 %");
  view = {Stage::upload, 0.0, 0.0, std::nullopt, "", 6.2};
  EXPECT_EQ(plain_line(view), "uploading    0 %");
}

TEST(TerminalLine, ColoursOnlyIfAsked) {
  const std::string plain = terminal_line(kView, 80, false);
  std::string colored = terminal_line(kView, 80, true);
  EXPECT_EQ(plain.find('\x1b'), std::string::npos);
  for (const std::string code : {"\x1b[32m", "\x1b[0m"}) {
    const auto at = colored.find(code);
    ASSERT_NE(at, std::string::npos);
    colored.erase(at, code.size());
  }
  EXPECT_EQ(colored, plain);
}

/// A progress bar that writes into a string.
struct Recorded {
  explicit Recorded(ProgressStyle::Mode mode)
      : bar({mode, false, [] { return 80; }}, [this](std::string_view part) { text += part; }) {}

  std::string text;
  ProgressBar bar;
};

TEST(ProgressBar, WritesSparseLinesToFiles) {
  Recorded recorded(ProgressStyle::Mode::lines);
  for (int i = 0; i <= 10000; ++i) {
    // The reports cover forty seconds and come a hundred times as often as lines are due.
    recorded.bar.update({Stage::rays, i / 10000.0, static_cast<std::uint64_t>(i), i * 0.004, 0});
  }
  const auto lines = std::count(recorded.text.begin(), recorded.text.end(), '\n');
  EXPECT_GE(lines, 8);
  EXPECT_LE(lines, 12);
  EXPECT_EQ(recorded.text.find('\r'), std::string::npos);
  EXPECT_EQ(recorded.text.find('\x1b'), std::string::npos);
}

TEST(ProgressBar, KeepsAliveInLongStages) {
  Recorded recorded(ProgressStyle::Mode::lines);
  for (int i = 0; i <= 120; ++i) recorded.bar.update({Stage::world, 0.0, 0, i * 0.1, 0});
  EXPECT_EQ(std::count(recorded.text.begin(), recorded.text.end(), '\n'), 2);
}

TEST(ProgressBar, RedrawsOneLineOnATerminalAndClearsIt) {
  Recorded recorded(ProgressStyle::Mode::terminal);
  for (int i = 0; i <= 1000; ++i) recorded.bar.update({Stage::rays, i / 1000.0, 0, i * 0.001, 0});
  EXPECT_EQ(recorded.text.find('\n'), std::string::npos);
  const auto drawn = std::count(recorded.text.begin(), recorded.text.end(), '\r');
  EXPECT_GE(drawn, 9);
  EXPECT_LE(drawn, 12);
  recorded.text.clear();
  recorded.bar.message("a warning");
  EXPECT_EQ(recorded.text, "\r\x1b[Ka warning\n");
  recorded.text.clear();
  recorded.bar.update({Stage::done, 1.0, 0, 1.1, 4});
  EXPECT_EQ(recorded.text, "");
}

TEST(ProgressBar, MeasuresTheTracingAlone) {
  Recorded recorded(ProgressStyle::Mode::terminal);
  recorded.bar.update({Stage::world, 0.5, 0, 3.0, 0});
  recorded.bar.update({Stage::rays, 0.0, 0, 10.0, 0});
  recorded.text.clear();
  recorded.bar.update({Stage::rays, 0.25, 20000000, 12.0, 0});
  EXPECT_NE(recorded.text.find("10.0 Mrays/s"), std::string::npos) << recorded.text;
  EXPECT_NE(recorded.text.find("6 s left"), std::string::npos) << recorded.text;
}

TEST(ProgressBar, IsSilentIfQuiet) {
  EXPECT_EQ(stderr_style(true).mode, ProgressStyle::Mode::none);
  Recorded recorded(ProgressStyle::Mode::none);
  for (int i = 0; i < 100; ++i) recorded.bar.update({Stage::rays, i / 100.0, 0, i * 1.0, 0});
  EXPECT_EQ(recorded.text, "");
}

TEST(Interrupt, TurnsASignalIntoAStop) {
  {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.token().stop_requested());
  }
  const auto before = std::signal(SIGTERM, SIG_DFL);
  {
    const Interrupt interrupt;
    std::raise(SIGTERM);
    for (int i = 0; i < 500 && !interrupt.token().stop_requested(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(interrupt.token().stop_requested());
    EXPECT_EQ(interrupt_exit_code(), 143);
  }
  std::signal(SIGTERM, before);
}

TEST(Stats, SayRatesAndWhatWasKept) {
  render::Stats stats;
  stats.rays[render::KernelStage::primary] = 3000000;
  stats.device_seconds[render::KernelStage::primary] = 0.5;
  stats.worlds_built = 2;
  const std::string text = stats_text(stats, 3u << 20);
  EXPECT_NE(text.find("3,000,000 rays, 0.50 s on the device, 6.00 Mrays/s"), std::string::npos);
  EXPECT_NE(text.find("2 built"), std::string::npos);
  EXPECT_NE(text.find("3.0 MiB at most"), std::string::npos);
  EXPECT_GT(peak_memory_bytes(), 1u << 20);

  stats.devices = {{"0:0/2.0", "half", 2000000, {0.25, 0.25, 0.25, 0.25}, 5u << 20}};
  EXPECT_EQ(stats_text(stats, 0).find("0:0/2.0"), std::string::npos) << "one device is all";
  stats.devices.push_back({"0:0/2.1", "half", 1000000, {0.25, 0.25, 0.0, 0.25}, 7u << 20});
  const std::string two = stats_text(stats, 0);
  EXPECT_NE(two.find("on 0:0/2.0: 2,000,000 primary rays, 66.7 % of them, 8.00 Mrays/s; busy for "
                     "1.00 s, 5.0 MiB\n"),
            std::string::npos)
      << two;
  EXPECT_NE(two.find("on 0:0/2.1: 1,000,000 primary rays, 33.3 %"), std::string::npos) << two;
}

}  // namespace
}  // namespace aerostat::cli
