#include "in_process.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <sstream>
#include <thread>

#include "graze/report/csv/csv.hpp"
#include "program.hpp"

namespace graze {
namespace {

namespace py = pybind11;

// As often as a person who pressed Ctrl-C expects an answer.
constexpr std::chrono::milliseconds kPause{50};

std::vector<std::string> names_in(const std::string& header) {
  std::vector<std::string> names;
  std::istringstream line(header.substr(0, header.find('\n')));
  for (std::string name; std::getline(line, name, ',');) names.push_back(name);
  return names;
}

// Work in a thread, and the end of it.
class WorkThread {
 public:
  explicit WorkThread(const Command& command)
      : thread_([this, &command] {
          try {
            run_command(command);
          } catch (...) {
            error_ = std::current_exception();
          }
          const std::lock_guard lock(mutex_);
          is_done_ = true;
          done_.notify_one();
        }) {}
  WorkThread(const WorkThread&) = delete;
  WorkThread& operator=(const WorkThread&) = delete;
  ~WorkThread() { thread_.join(); }

  // Whether it is done, now or soon.
  bool waited() {
    std::unique_lock lock(mutex_);
    return done_.wait_for(lock, kPause, [this] { return is_done_; });
  }
  const std::exception_ptr& error() const { return error_; }

 private:
  std::mutex mutex_;
  std::condition_variable done_;
  bool is_done_ = false;
  std::exception_ptr error_;
  std::thread thread_;  // begins when all else is there
};

}  // namespace

void FoundResult::hear(const Sample& sample) {
  row_.clear();
  add_sample_row(*system_, sample, *probes_, row_);
  samples_->add(row_);
}

void FoundResult::begin_run(const System& system, const std::vector<ProbeRow>& probes,
                            bool energy) {
  system_ = &system;
  probes_ = &probes;
  samples_ = std::make_unique<Rows>(names_in(samples_csv_header(system, energy, probes)));
}

void FoundResult::take(AnyRecord record, const Scene& scene) {
  record_ = std::move(record);
  scene_ = scene;
}

std::shared_ptr<FoundResult> run_in_process(Command command, const py::object& progress) {
  const auto found = std::make_shared<FoundResult>();
  std::visit([&](CommonOptions& common) { common.caller = found.get(); }, command);
  std::optional<py::error_already_set> raised;
  std::exception_ptr error;
  {
    py::gil_scoped_release release;
    WorkThread work(command);
    while (!work.waited()) {
      const py::gil_scoped_acquire lock;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (!progress.is_none()) progress(found->progress());
      } catch (py::error_already_set& exception) {
        raised.emplace(std::move(exception));
        found->stop();
      }
    }
    error = work.error();
  }
  if (raised) {
    if (found->record()) raised->value().attr("result") = py::cast(found);
    throw std::move(*raised);
  }
  if (error) std::rethrow_exception(error);
  if (!progress.is_none()) progress(1.0);
  return found;
}

}  // namespace graze
