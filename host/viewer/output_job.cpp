#include "viewer/output_job.hpp"

#include <exception>
#include <new>
#include <utility>

#include "core/error.hpp"

namespace aerostat::viewer {

OutputJob::OutputJob() : watch_([this](int seconds) { Q_EMIT fell_silent(seconds); }, [] {}) {}

void OutputJob::Ender::operator()(OutputJob* job) const {
  job->cancel();
  if (!job->thread_.joinable() || ends_soon(job->ended_, job->watch_)) {
    delete job;
    return;
  }
  job->disconnect();
  job->watch_.stop();
  leave_behind(job);
}

void OutputJob::cancel() {
  thread_.request_stop();
}

void OutputJob::begin(std::function<void(const std::stop_token& stop)> work) {
  thread_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
    run(work, stop);
    end_.set_value();
  });
}

void OutputJob::run(const std::function<void(const std::stop_token& stop)>& work,
                    const std::stop_token& stop) {
  try {
    work(stop);
  } catch (const Error& error) {
    const bool is_cancelled = error.kind() == ErrorKind::interrupted;
    Q_EMIT finished(false, is_cancelled ? QString() : QString::fromUtf8(error.what()));
  } catch (const std::bad_alloc&) {
    Q_EMIT finished(false, tr("Out of memory"));
  } catch (const std::exception& error) {
    Q_EMIT finished(false, QString::fromUtf8(error.what()));
  }
}

}  // namespace aerostat::viewer
