#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/stop_scope.hpp"

namespace aerostat::render {

/// Runs long work of the host beside the caller, who can give up waiting for it. Work that is given
/// up is asked to stop by its StopScope, and runs on until it stops or ends, without a result.
/// Everything it refers to must belong to it. New work waits while more than one given-up work is
/// still running, so that they never pile up. The destructor waits for all of them.
class AbandonableWork {
 public:
  /// Returns the result of `work()` or throws its exception. Throws Error{interrupted} soon after
  /// `stop` is requested. Calls `waiting()` every 20 ms until then.
  template <typename Work, typename Waiting>
  auto run(Work work, const std::stop_token& stop, Waiting waiting) -> decltype(work()) {
    while (given_up() > 1) {
      waiting();
      stop_if_asked(stop);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::packaged_task<decltype(work())()> task([work = std::move(work), stop]() mutable {
      const StopScope scope(stop);
      return work();
    });
    // A future can be moved only, and what remembers abandoned work must be copyable.
    const auto result = std::make_shared<std::future<decltype(work())>>(task.get_future());
    std::jthread thread(std::move(task));
    while (result->wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) {
      waiting();
      if (stop.stop_requested()) {
        const auto ended = [result] {
          return result->wait_for(std::chrono::seconds(0)) == std::future_status::ready;
        };
        abandoned_.push_back({std::move(thread), ended});
        throw Error(ErrorKind::interrupted, "interrupted");
      }
    }
    return result->get();
  }

 private:
  struct Abandoned {
    std::jthread thread;
    std::function<bool()> ended;
  };

  /// Returns how many given-up works are still running, and forgets those that have ended. A user
  /// who drags the view gives up work at every movement.
  std::size_t given_up() {
    std::erase_if(abandoned_, [](const Abandoned& one) { return one.ended(); });
    return abandoned_.size();
  }

  std::vector<Abandoned> abandoned_;
};

}  // namespace aerostat::render
