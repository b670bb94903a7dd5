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

/// Runs long host work beside the caller, who can give up waiting for it: the work is asked to stop
/// by its StopScope, and is left to itself until it does, or comes to its end unheard. What it
/// refers to must be its own. New work waits while more than one piece of it is at work, so that it
/// never piles up. The destructor waits for all of it.
class AbandonableWork {
 public:
  /// The result of `work()`, or its exception. Throws Error{interrupted} soon after `stop` is
  /// requested. `waiting()` is called every 20 ms meanwhile.
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
    auto result = task.get_future().share();
    std::jthread thread(std::move(task));
    while (result.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) {
      waiting();
      if (stop.stop_requested()) {
        const auto ended = [result] {
          return result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
        };
        abandoned_.push_back({std::move(thread), ended});
        throw Error(ErrorKind::interrupted, "interrupted");
      }
    }
    return result.get();
  }

 private:
  struct Abandoned {
    std::jthread thread;
    std::function<bool()> ended;
  };

  /// Someone who drags a view about gives up work at every turn. How many are at work.
  std::size_t given_up() {
    std::erase_if(abandoned_, [](const Abandoned& one) { return one.ended(); });
    return abandoned_.size();
  }

  std::vector<Abandoned> abandoned_;
};

}  // namespace aerostat::render
