#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "frond/frond.h"
#include "python/python.h"

namespace frond {

namespace {

/// A render in a thread of its own. What it says is taken line by line.
class Render final : public api::Listener {
 public:
  Render(api::Preset preset, std::filesystem::path folder, api::RenderOptions options)
      : thread_([this, preset = std::move(preset), folder = std::move(folder), options = std::move(options)] {
          work(preset, folder, options);
        }) {}
  ~Render() override { stop(); }

  /// The next thing it says, with the numbers of frames that are done and of all, or 0; waits for it. Nothing
  /// at the end.
  struct Said {
    std::string line;
    int done = 0, all = 0;
  };
  std::optional<Said> next() {
    py::gil_scoped_release others;
    std::unique_lock lock(mutex_);
    more_.wait(lock, [&] { return over_ || !said_.empty(); });
    if (said_.empty()) return std::nullopt;
    Said first = std::move(said_.front());
    said_.pop_front();
    return first;
  }
  /// Ends it, with the frames that POV-Ray is at.
  void stop() {
    py::gil_scoped_release others;
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  /// What it has made, after its end; what went wrong otherwise.
  std::vector<std::filesystem::path> files() const { return files_; }
  std::string fault() const { return fault_; }

  void note(std::string_view line) override { say({std::string(line)}); }
  void rendered(int done, int all, std::string_view words) override { say({std::string(words), done, all}); }
  bool cancelled() override { return stop_; }

 private:
  void say(Said said) {
    std::lock_guard lock(mutex_);
    said_.push_back(std::move(said));
    more_.notify_all();
  }
  void work(const api::Preset& preset, const std::filesystem::path& folder,
            const api::RenderOptions& options) {
    try {
      files_ = api::render(preset, folder, options, this);
    } catch (const std::exception& error) {
      fault_ = error.what();
    }
    std::lock_guard lock(mutex_);
    over_ = true;
    more_.notify_all();
  }

  std::mutex mutex_;  // guards said_ and over_
  std::condition_variable more_;
  std::deque<Said> said_;
  bool over_ = false;
  std::atomic<bool> stop_ = false;
  std::vector<std::filesystem::path> files_;
  std::string fault_;
  std::thread thread_;
};

using Sets = std::vector<std::pair<std::string, std::string>>;

std::unique_ptr<Render> render(const std::optional<std::string>& text, const std::filesystem::path& file,
                               const Sets& sets, const std::optional<std::filesystem::path>& assets,
                               const std::filesystem::path& folder, const api::RenderOptions& options) {
  py::gil_scoped_release others;
  auto preset = [&] {
    api::Preset read = text ? api::Preset::parse(*text, file, assets) : api::Preset::read(file, assets);
    for (const auto& [pointer, value] : sets) read.set(pointer, value);
    return read;
  };
  try {
    return std::make_unique<Render>(preset(), folder, options);
  } catch (const api::Failure& failure) {
    Errors errors;
    for (const api::Message& message : failure.messages()) errors.push_back({message.where, message.what});
    py::gil_scoped_acquire back;
    raise(errors);
  }
}

}  // namespace

void add_renders(py::module_& module) {
  py::class_<Render>(module, "Render")
      .def("next",
           [](Render& r) -> py::object {
             auto said = r.next();
             return said ? py::object(py::make_tuple(said->line, said->done, said->all)) : py::none();
           })
      .def("stop", &Render::stop)
      .def_property_readonly("files", &Render::files)
      .def_property_readonly("fault", &Render::fault);
  module.def("render",
             [](const std::optional<std::string>& text, const std::filesystem::path& file, const Sets& sets,
                const std::optional<std::filesystem::path>& assets, const std::filesystem::path& folder,
                const std::optional<std::array<int, 2>>& frames, const std::string& format, int jobs,
                const std::filesystem::path& program) {
               return render(text, file, sets, assets, folder,
                             {.frames = frames, .format = format, .jobs = jobs, .program = program});
             });
}

}  // namespace frond
