// Tests that host and device have the same layout of bytes.
#include <cstddef>

#include "bvh_node.h"
#include "camera.h"
#include "film_pixel.h"
#include "instance.h"
#include "packet_words.h"
#include "probe.hpp"
#include "scene_params.h"
#include "trace_triangle.h"

namespace aerostat::test {
namespace {

struct Entry {
  const char* what;
  std::size_t bytes;
};

std::vector<Entry> host_layout() {
  return {
#define STRUCT(type) {"size of " #type, sizeof(type)},
#define FIELD(type, field)                                \
  {"offset of " #type "." #field, offsetof(type, field)}, \
      {"size of " #type "." #field, sizeof(type::field)},
#include "probes/layout_fields.h"
#undef STRUCT
#undef FIELD
  };
}

class Layout : public LaneTest {};

TEST_P(Layout, OfSharedStructsIsTheHosts) {
  const std::vector<Entry> expected = host_layout();
  const auto reported = output<std::uint32_t>(expected.size() + 1);
  Probe("layout.cl", GetParam()).run_items("report_layout", 1, reported);
  const std::vector<std::uint32_t> actual = reported.read();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(actual[i], expected[i].bytes) << expected[i].what;
  }
}

// Tests that the list is complete: the fields of a struct fill it without a gap.
TEST(LayoutList, NamesEveryField) {
  std::size_t filled = 0, size = 0;
  const char* name = "";
  const auto close = [&] { EXPECT_EQ(filled, size) << name; };
#define STRUCT(type) close(), name = #type, size = sizeof(type), filled = 0;
#define FIELD(type, field)                          \
  EXPECT_EQ(offsetof(type, field), filled) << name; \
  filled += sizeof(type::field);
#include "probes/layout_fields.h"
#undef STRUCT
#undef FIELD
  close();
}

// Tests that a hit is five words per lane, because the host allocates buffers of hits in this size.
TEST_P(Layout, OfAPacketOfHitsIsFiveWordsALane) {
  const auto reported = output<std::uint32_t>(6);
  Probe("layout.cl", GetParam()).run_items("report_hit", 1, reported);
  const auto lane_bytes = static_cast<std::uint32_t>(4 * GetParam());
  EXPECT_EQ(reported.read(),
            (std::vector<std::uint32_t>{5 * lane_bytes, 0, lane_bytes, 2 * lane_bytes,
                                        3 * lane_bytes, 4 * lane_bytes}));
}

AEROSTAT_AT_EVERY_WIDTH(Layout);

}  // namespace
}  // namespace aerostat::test
