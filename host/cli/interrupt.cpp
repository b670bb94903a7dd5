#include "cli/interrupt.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "core/error.hpp"

namespace aerostat::cli {

namespace {

constexpr std::array kSignals{SIGINT, SIGTERM};
constexpr char kStop = 's';
constexpr char kEnd = 'e';

// A signal handler can reach only global variables.
std::atomic<int> signal_seen{0};
std::atomic<int> pipe_end{-1};
std::array<struct sigaction, kSignals.size()> former{};

static_assert(std::atomic<int>::is_always_lock_free);

void send(char byte) {
  while (::write(pipe_end.load(), &byte, 1) < 0 && errno == EINTR) {
  }
}

extern "C" void on_signal(int number) {
  const int saved_errno = errno;
  signal_seen.store(number);
  for (int signal : kSignals) std::signal(signal, SIG_DFL);
  send(kStop);
  errno = saved_errno;
}

void install(std::size_t index) {
  ::sigaction(kSignals[index], nullptr, &former[index]);
  if (former[index].sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(kSignals[index], &action, nullptr);
}

// Returns the next byte, or kEnd after `milliseconds`. A value of -1 waits without limit.
char receive(int pipe, int milliseconds, bool& in_time) {
  pollfd waiting{pipe, POLLIN, 0};
  int count = 0;
  do {
    count = ::poll(&waiting, 1, milliseconds);
  } while (count < 0 && errno == EINTR);
  char byte = kEnd;
  in_time = count > 0 && ::read(pipe, &byte, 1) == 1;
  return byte;
}

}  // namespace

Interrupt::Interrupt() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    throw Error(ErrorKind::exhausted, "preparing for interrupts: no pipe can be opened");
  }
  pipe_end.store(ends[1]);
  watcher_ = std::thread([this, pipe = ends[0]] { watch(pipe); });
  for (std::size_t i = 0; i < kSignals.size(); ++i) install(i);
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &former[i], nullptr);
  send(kEnd);
  watcher_.join();
  ::close(pipe_end.exchange(-1));
}

void Interrupt::watch(int pipe) {
  bool in_time = true;
  if (receive(pipe, -1, in_time) == kStop) {
    source_.request_stop();
    receive(pipe, grace_ms_, in_time);
    if (!in_time && grace_ms_ == kNoLimit) receive(pipe, kNoLimit, in_time);
    if (!in_time) {
      // Other threads still work, so that only an end without their clean-up is safe. Files are
      // written in such a way that nothing of them is left behind.
      const std::string_view message = ::isatty(STDERR_FILENO) == 1
                                           ? "\r\x1b[Kaerostat: interrupted\n"
                                           : "aerostat: interrupted\n";
      [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, message.data(), message.size());
      std::_Exit(interrupt_exit_code());
    }
  }
  ::close(pipe);
}

int interrupt_exit_code() {
  return 128 + (signal_seen.load() == SIGTERM ? SIGTERM : SIGINT);
}

}  // namespace aerostat::cli
