#pragma once

/// Declares the classes of OpenCL's C++ bindings. Headers use only their names, so that only the
/// sources of this folder read the bindings (cl.hpp), which are large.
namespace cl {
class Buffer;
class CommandQueue;
class Context;
class Device;
class Event;
class Kernel;
class Program;
}  // namespace cl
