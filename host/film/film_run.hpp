#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "film/encoder.hpp"
#include "film/frame_files.hpp"
#include "film/frames.hpp"
#include "film/timeline.hpp"
#include "render/session.hpp"
#include "scene/source.hpp"

/// Making the files of a film, for the command and the window alike.
namespace aerostat::film {

/// What a film is written to.
struct FilmFiles {
  std::filesystem::path video;  // empty: only frames
  FrameNames names;
  std::filesystem::path sheet;  // of the contact sheet; empty: none
  FrameFormat format = FrameFormat::png;
};

/// Returns the files of a film by the name of its output: "flight.mp4", whose frames stand in
/// flight.frames, or frames alone, such as "frames/####.png" or "frames/####.exr". The frames of a
/// preview stand in a folder of their own. Throws Error{usage} for other names.
FilmFiles film_files(const std::filesystem::path& output, bool is_preview = false);

/// Returns a scene with which the movement of a film can be looked at quickly: small frames of one
/// sample, without soft light and motion blur.
scene::SceneSource preview_of(const scene::SceneSource& source);

/// A frame of the film, its mark, and what its file holds.
struct Frame {
  int number = 1;
  std::string mark;
  FrameState state = FrameState::missing;
};

/// Reads the files of some frames. Throws Error{interrupted} if `stop` is requested.
std::vector<Frame> survey(Timeline& timeline, const FilmFiles& files,
                          const std::vector<int>& numbers, const std::stop_token& stop);

/// Returns how many frames are in a state.
int count_of(const std::vector<Frame>& frames, FrameState state);

/// How far the frames of a film are.
struct FilmProgress {
  int number = 0;  // the frame that is made
  int made = 0;    // frames that were made
  int to_make = 0;
  double seconds = 0.0;
  double frames_per_s = 0.0;  // 0 before the second frame, because the first one builds the land
  /// Of the frame. Its share is that of the samples.
  render::Progress render;

  /// Returns the share of the frames that are made, 0 to 1.
  double fraction() const;
};

/// What is to be made.
struct FilmTask {
  FilmFiles files;
  EncoderOptions encoder;     // without an output: only frames are made
  double time_limit_s = 0.0;  // 0: none
  bool has_sheet = true;      // a contact sheet is written at the end
};

/// What was made.
struct FilmOutcome {
  int made = 0, left = 0;
  /// Why there is no film of the frames, if ffmpeg is not there.
  std::optional<Error> no_encoder;
};

/// Makes the frames that are missing and encodes the film beside that. With a limit of time, at
/// least one frame is made, so that repeated calls come to an end; the film is only finished if no
/// frame is left. Without ffmpeg, the frames are made nevertheless. `options` name the cache whose
/// relief the timeline uses. `show` is called from the thread that renders, and with the number 0
/// while ffmpeg ends its work. Throws Error{interrupted} if `stop` is requested, Error{io} where
/// files cannot be written or ffmpeg fails, and the errors of render::Session.
FilmOutcome make_film(Timeline& timeline, const render::Options& options, const FilmTask& task,
                      const std::vector<Frame>& frames, const std::stop_token& stop,
                      const std::function<void(const FilmProgress&)>& show);

}  // namespace aerostat::film
