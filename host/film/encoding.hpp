#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "film/encoder.hpp"
#include "film/frames.hpp"

namespace aerostat::film {

/// Encodes a film beside the work that makes its frames. The frames are read from their files, so
/// that none are kept in memory.
class Encoding {
 public:
  /// Takes the frames of the film in their order. Throws the errors of Encoder.
  Encoding(const EncoderOptions& options, const FrameNames& names, std::vector<int> frames);
  /// Gives the film up unless it is finished.
  ~Encoding();
  Encoding(const Encoding&) = delete;
  Encoding& operator=(const Encoding&) = delete;

  /// Tells that the file of a frame is there.
  void add(int frame);

  /// Waits for the film, of which all frames must be there. Throws the errors of Encoder, and
  /// Error{bad_data} if a frame's file cannot be decoded or has another size.
  void finish();

 private:
  void work();
  bool wait_for(int frame);

  EncoderOptions options_;
  FrameNames names_;
  std::vector<int> frames_;
  Encoder encoder_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::set<int> there_;
  bool is_given_up_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace aerostat::film
