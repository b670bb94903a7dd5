// Tests the choice of frames and the names of their files.
#include "film/frames.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/error_of.hpp"

namespace aerostat::film {
namespace {

using Numbers = std::vector<int>;

TEST(Frames, RangesAreRead) {
  EXPECT_EQ(frames_of(parse_frames("3"), {}, 10), (Numbers{3}));
  EXPECT_EQ(frames_of(parse_frames("3-5"), {}, 10), (Numbers{3, 4, 5}));
  EXPECT_EQ(frames_of(parse_frames("2-9:3"), {}, 10), (Numbers{2, 5, 8}));
  EXPECT_EQ(frames_of(parse_frames("8-"), {}, 10), (Numbers{8, 9, 10}));
  EXPECT_EQ(frames_of(parse_frames("-2"), {}, 10), (Numbers{1, 2}));
  EXPECT_EQ(frames_of(parse_frames("9-2000"), {}, 10), (Numbers{9, 10}));
  EXPECT_EQ(frames_of({}, {}, 3), (Numbers{1, 2, 3}));
}

TEST(Frames, MistakesAreTold) {
  for (const char* text :
       {"", "-", "0", "5-2", "1-5:0", "1-5:", "a", "1,2", "1-2-3", "1.5", "-:2x", "99999999999"}) {
    const Error error = test::error_of([&] { parse_frames(text); });
    EXPECT_EQ(error.kind(), ErrorKind::usage) << text;
  }
  for (const char* text : {"", "3", "0/8", "9/8", "/8", "3/", "a/b", "1/0"}) {
    const Error error = test::error_of([&] { parse_shard(text); });
    EXPECT_EQ(error.kind(), ErrorKind::usage) << text;
  }
  EXPECT_EQ(test::error_of([] { frames_of(parse_frames("11"), {}, 10); }).kind(), ErrorKind::usage);
}

TEST(Frames, ShardsHaveEachFrameOnce) {
  for (int film = 1; film <= 40; ++film) {
    for (int count = 1; count <= 12; ++count) {
      for (const char* range : {"1-", "2-", "1-:3"}) {
        if (film == 1 && std::string(range) == "2-") continue;
        const Numbers whole = frames_of(parse_frames(range), {}, film);
        Numbers joined;
        for (int index = 1; index <= count; ++index) {
          const Numbers part = frames_of(parse_frames(range), {index, count}, film);
          EXPECT_LE(part.size(), whole.size() / static_cast<std::size_t>(count) + 1);
          joined.insert(joined.end(), part.begin(), part.end());
        }
        EXPECT_EQ(joined, whole) << film << " frames in " << count;
      }
    }
  }
}

TEST(FrameNames, HaveTheNumberInPlaceOfTheSigns) {
  const FrameNames names("out/a-####.b.png");
  EXPECT_EQ(names.name(7), "out/a-0007.b.png");
  EXPECT_EQ(names.name(12345), "out/a-12345.b.png");
  EXPECT_EQ(names.folder(), "out");
  EXPECT_EQ(FrameNames("#.png").folder(), ".");
  for (const char* pattern : {"frames.png", "#a#.png", "##/a.png"}) {
    EXPECT_EQ(test::error_of([&] { FrameNames{pattern}; }).kind(), ErrorKind::usage) << pattern;
  }
}

}  // namespace
}  // namespace aerostat::film
