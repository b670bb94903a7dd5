// Tests programs, buffers and launches on a real device. A machine without a device is a failure.
#include <numeric>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "opencl/buffer.hpp"
#include "opencl/launch.hpp"
#include "opencl/program.hpp"
#include "opencl/status.hpp"
#include "support/error_of.hpp"

namespace aerostat::opencl {
namespace {

template <typename TheKernel, typename... Args>
concept CanLaunch = requires(const Context& context, const TheKernel& kernel, const Args&... args) {
  launch(context, kernel, LaunchSize(1), args...);
};
using OfTwoBuffers = TypedKernel<Buffer<float>, Buffer<std::uint32_t>>;
static_assert(CanLaunch<OfTwoBuffers, Buffer<float>, Buffer<std::uint32_t>>);
static_assert(!CanLaunch<OfTwoBuffers, Buffer<std::uint32_t>, Buffer<float>>, "swapped buffers");
static_assert(!CanLaunch<OfTwoBuffers, Buffer<float>>, "one buffer too few");

using test::error_of;

/// Returns a context that is never destroyed, because OpenCL must not be called after main.
const Context& context() {
  static const auto& instance = *new Context(select_device(effective_selector("")));
  return instance;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct Line {
  float slope;
  float offset;
};

SourceTree tiny_tree() {
  return {{"tiny.cl",
           "#include \"wide.clh\"\n"
           "typedef struct Line { float slope; float offset; } Line;\n"
           "kernel void apply_line(global const float* x, Line line, global float* y, uint n) {\n"
           "  const size_t i = get_global_id(0);\n"
           "  if (i * LANES >= n) return;\n"
           "  WIDE_STORE(WIDE_LOAD(i, x) * line.slope + line.offset, i, y);\n"
           "}\n"},
          {"device/wide.clh",
           "#define JOIN_(a, b) a##b\n#define JOIN(a, b) JOIN_(a, b)\n"
           "#if LANES == 1\n"
           "#define WIDE_LOAD(i, p) (p)[i]\n#define WIDE_STORE(v, i, p) (p)[i] = (v)\n"
           "#else\n"
           "#define WIDE_LOAD(i, p) JOIN(vload, LANES)(i, p)\n"
           "#define WIDE_STORE(v, i, p) JOIN(vstore, LANES)(v, i, p)\n"
           "#endif\n"}};
}

class Widths : public testing::TestWithParam<int> {};

TEST_P(Widths, RunATinyKernel) {
  const Program program(context(), tiny_tree(), "tiny.cl", GetParam());
  EXPECT_EQ(program.lanes(), GetParam());
  auto kernel = program.kernel("apply_line");
  const unsigned count = 1024;
  std::vector<float> x(count);
  std::iota(x.begin(), x.end(), 0.0f);
  const MemoryBudget budget;
  const Buffer<float> input(context(), budget, std::span<const float>(x), "the input");
  const Buffer<float> output(context(), budget, count, "the output");
  const auto event = launch(context(), kernel, {count / static_cast<unsigned>(GetParam()), 32},
                            input, Line{2.0f, 1.0f}, output, count);
  EXPECT_GE(device_seconds(event), 0.0);
  const auto y = output.read();
  for (unsigned i = 0; i < count; ++i) ASSERT_EQ(y[i], 2.0f * x[i] + 1.0f) << i;
}

INSTANTIATE_TEST_SUITE_P(Program, Widths, testing::Values(1, 4, 8, 16));

TEST(Devices, AreListed) {
  const auto list = list_devices();
  ASSERT_FALSE(list.devices.empty()) << "install pocl-opencl-icd";
  for (const auto& device : list.devices) {
    EXPECT_FALSE(device.name.empty());
    EXPECT_GT(device.memory_bytes, 0u);
    EXPECT_GT(device.compute_units, 0u);
    EXPECT_EQ(pick(list, device.selector()).at(0).selector(), device.selector());
  }
}

TEST(ProgramErrors, CarryTheLogWithTheFileAndLine) {
  auto tree = tiny_tree();
  tree["device/wide.clh"] += "int broken(void) { return undeclared_thing; }\n";
  try {
    const Program program(context(), tree, "tiny.cl", 4);
    FAIL() << "it builds";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::internal);
    const std::string message = error.what();
    EXPECT_TRUE(contains(message, "tiny.cl")) << message;
    EXPECT_TRUE(contains(message, "device/wide.clh:10:")) << message;
    EXPECT_TRUE(contains(message, "undeclared_thing")) << message;
  }
}

TEST(ProgramErrors, NameAMissingKernel) {
  const Program program(context(), tiny_tree(), "tiny.cl", 1);
  try {
    program.kernel("missing_kernel");
    FAIL() << "it exists";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::internal);
    const std::string message = error.what();
    EXPECT_TRUE(contains(message, "missing_kernel of tiny.cl")) << message;
    EXPECT_TRUE(contains(message, "CL_INVALID_KERNEL_NAME from clCreateKernel")) << message;
    EXPECT_TRUE(contains(message, context().device().name)) << message;
    EXPECT_TRUE(contains(message, context().device().driver)) << message;
  }
}

TEST(Status, IsToldByItsKind) {
  const auto told = [](int status) {
    return error_of([&] { rethrow("testing", cl::Error(status, "clTest")); });
  };
  for (const int status :
       {CL_OUT_OF_HOST_MEMORY, CL_MEM_OBJECT_ALLOCATION_FAILURE, CL_MAP_FAILURE}) {
    EXPECT_EQ(told(status).kind(), ErrorKind::exhausted);
    EXPECT_TRUE(contains(told(status).what(), "not enough memory")) << told(status).what();
  }
  for (const int status : {CL_OUT_OF_RESOURCES, CL_INVALID_BUFFER_SIZE, CL_DEVICE_NOT_AVAILABLE,
                           CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST}) {
    EXPECT_EQ(told(status).kind(), ErrorKind::exhausted);
    EXPECT_TRUE(contains(told(status).what(), status_name(status) + " from clTest"));
  }
  for (const int status : {CL_INVALID_KERNEL_NAME, CL_INVALID_VALUE, CL_BUILD_PROGRAM_FAILURE}) {
    EXPECT_EQ(told(status).kind(), ErrorKind::internal);
  }
}

TEST(Program, TakesDefines) {
  const SourceTree tree{{"a.cl", "kernel void give(global int* out) { out[0] = ANSWER; }\n"}};
  const Program program(context(), tree, "a.cl", 1, {"ANSWER=42"});
  auto kernel = program.kernel("give");
  const Buffer<int> out(context(), {}, 1, "the answer");
  launch(context(), kernel, 1, out);
  EXPECT_EQ(out.read(), std::vector<int>{42});
  EXPECT_THROW(Program(context(), tree, "a.cl", 1, {"A=1 -cl-fast-relaxed-math"}), Error);
}

TEST(Launch, SkipsAnEmptyRangeAndNamesAWrongArgument) {
  const SourceTree tree{{"a.cl", "kernel void take_one(uint n) {}\n"}};
  const Program program(context(), tree, "a.cl", 1);
  auto kernel = program.kernel("take_one");
  const auto event = launch(context(), kernel, 0, 1u);
  EXPECT_EQ(event, nullptr);
  EXPECT_EQ(device_seconds(event), 0.0);
  try {
    launch(context(), kernel, 1, 1u, 2u);
    FAIL() << "two arguments for one";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::internal);
    EXPECT_TRUE(contains(error.what(), "argument 1")) << error.what();
    EXPECT_TRUE(contains(error.what(), "take_one")) << error.what();
  }
}

TEST(Launch, GroupSizesDivideTheRange) {
  EXPECT_EQ(dividing_group_size(1024, 64), 64u);
  EXPECT_EQ(dividing_group_size(100, 64), 50u);
  EXPECT_EQ(dividing_group_size(97, 64), 1u);
  EXPECT_EQ(dividing_group_size(3, 64), 3u);
  EXPECT_EQ(dividing_group_size(100, 0), 0u);
}

TEST(Buffers, WriteReadAndStartAsZero) {
  Buffer<int> buffer(context(), {}, 5, "numbers");
  EXPECT_EQ(buffer.read(), std::vector<int>(5, 0));
  const std::vector<int> two{7, 8};
  buffer.write(std::span<const int>(two), 3);
  EXPECT_EQ(buffer.read(), (std::vector<int>{0, 0, 0, 7, 8}));
  EXPECT_THROW(buffer.write(std::span<const int>(two), 4), Error);
  EXPECT_EQ(buffer.bytes(), 20u);

  const auto moved = std::move(buffer);
  EXPECT_EQ(moved.read().back(), 8);
}

TEST(Buffers, MayBeLookedAtWhereTheyAre) {
  const std::vector<int> numbers = {3, 1, 4, 1, 5, 9};
  const opencl::Buffer<int> buffer(context(), {}, numbers, "the numbers");
  std::vector<int> seen;
  buffer.look_at(1, 3, [&](std::span<const int> part) { seen.assign(part.begin(), part.end()); });
  EXPECT_EQ(seen, (std::vector<int>{1, 4, 1}));
  buffer.look_at(6, 0, [&](std::span<const int> part) { seen.assign(part.begin(), part.end()); });
  EXPECT_TRUE(seen.empty());
  EXPECT_THROW(buffer.look_at(4, 3, [](auto) {}), Error);
}

TEST(Buffers, MayBeEmpty) {
  const MemoryBudget budget;
  const Buffer<float> none(context(), budget, std::span<const float>(), "nothing");
  EXPECT_EQ(none.size(), 0u);
  EXPECT_TRUE(none.read().empty());
  EXPECT_NE(none.raw().handle(), nullptr);
  EXPECT_EQ(budget.used(), 16u);
}

TEST(Buffers, LendMemoryUntilTheDeviceIsDoneWithIt) {
  const SourceTree tree{{"a.cl",
                         "kernel void copy(global const int* x, global int* y) {\n"
                         "  y[get_global_id(0)] = x[get_global_id(0)];\n}\n"}};
  const Program program(context(), tree, "a.cl", 1);
  auto kernel = program.kernel("copy");
  MemoryBudget budget;
  auto numbers = std::make_shared<std::vector<int>>(1000);
  std::iota(numbers->begin(), numbers->end(), 0);
  const std::weak_ptr<std::vector<int>> watched = numbers;
  Buffer<int> output(context(), {}, 1000, "the output");
  {
    Buffer<int> lent(context(), budget, numbers, std::span<const int>(*numbers), "numbers");
    EXPECT_EQ(budget.used(), 4000u);
    const std::vector<int> expected = *numbers;
    numbers = nullptr;
    launch(context(), kernel, 1000, lent, output);
    const Buffer<int> moved = std::move(lent);
    EXPECT_FALSE(watched.expired());
    EXPECT_EQ(output.read(), expected);
  }
  EXPECT_TRUE(watched.expired());
  EXPECT_EQ(budget.used(), 0u);
}

TEST(Buffers, StayWithinTheBudget) {
  const MemoryBudget budget(4096);
  {
    Buffer<char> first(context(), budget, 3000, "the first");
    EXPECT_EQ(budget.used(), 3008u);
    try {
      const Buffer<char> second(context(), budget, 2000, "the second");
      FAIL() << "beyond the budget";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::exhausted);
      EXPECT_TRUE(contains(error.what(), "the second")) << error.what();
      EXPECT_TRUE(contains(error.what(), "--memory-limit")) << error.what();
    }
    EXPECT_EQ(budget.used(), 3008u);
    first = Buffer<char>(context(), budget, 100, "the third");
    EXPECT_EQ(budget.used(), 112u);
  }
  EXPECT_EQ(budget.used(), 0u);
  EXPECT_THROW(Buffer<double>(context(), budget, ~std::size_t{0} / 16, "too much"), Error);
}

}  // namespace
}  // namespace aerostat::opencl
