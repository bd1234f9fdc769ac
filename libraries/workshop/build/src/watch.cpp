#include "elsie/build/watch.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include "elsie/build/source_build.h"
#include "elsie/plugin/file_fingerprint.h"
#include "elsie/plugin/kind_name.h"

namespace elsie::build {
namespace {

namespace fs = std::filesystem;

/// What was seen of files; those that are not there are not in it.
using Sight = std::map<fs::path, plugin::Fingerprint>;

void look_at(const fs::path& file, Sight& sight) {
  if (const auto fingerprint = plugin::fingerprint_of(file)) {
    sight.insert_or_assign(file, *fingerprint);
  }
}

bool is_header(const fs::path& file) {
  const std::string end = file.extension().string();
  return end.starts_with(".h") || end == ".inc" || end == ".ipp" || end == ".tpp";
}

/// The files of a folder that one is looking for; none when it cannot be read.
template <class Wanted>
std::vector<fs::path> files_in(const fs::path& folder, Wanted wanted) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (wanted(at->path())) {
      files.push_back(at->path());
    }
  }
  return files;
}

bool has_changed(const fs::path& file, const Sight& before, const Sight& now) {
  const auto old = before.find(file), fresh = now.find(file);
  return (old == before.end()) != (fresh == now.end()) ||
         (old != before.end() && old->second != fresh->second);
}

/// Where plugins are looked for, sources being compiled.
class Places {
 public:
  explicit Places(std::vector<plugin::SearchDirectory> places) {
    for (plugin::SearchDirectory& place : places) {
      places_.push_back({std::move(place), {}, false});
      if (is_source(places_.back().place.path)) {
        places_.back().build = build_source(places_.back().place.path);
      }
    }
  }

  /// Compiles again what was saved since it was compiled first; for the rest the cache has it.
  void refresh() {
    for (Place& place : places_) {
      if (!place.build.library.empty()) {
        place.build = build_source(place.place.path);
      }
    }
  }

  /// For a host: libraries and directories.
  std::vector<plugin::SearchDirectory> directories() const {
    std::vector<plugin::SearchDirectory> directories;
    for (const Place& place : places_) {
      directories.push_back(place.place);
      if (!place.build.library.empty()) {
        directories.back().source = place.place.path;
        directories.back().path = place.build.library;
      }
    }
    return directories;
  }

  /// What the files look like now.
  Sight look() const {
    Sight sight;
    for (const Place& place : places_) {
      for (const fs::path& file : files_of(place)) {
        look_at(file, sight);
      }
    }
    return sight;
  }

  /// Compiles the sources of which something has changed; adds those that cannot be compiled to
  /// what is kept, and what the compiler has to say of them to the problems.
  void rebuild(const Sight& before, const Sight& now, const std::stop_token& stop,
               Renewal& renewal) {
    for (Place& place : places_) {
      if (place.build.library.empty() || stop.stop_requested()) {
        continue;
      }
      // What one that does not compile includes is not known: any header beside it may be at fault.
      const auto inputs = place.is_refused ? files_of(place) : place.build.inputs;
      if (std::none_of(inputs.begin(), inputs.end(),
                       [&](const fs::path& input) { return has_changed(input, before, now); })) {
        continue;
      }
      place.is_refused = true;
      try {
        place.build = build_source(place.place.path, cache_directory(), stop);
        place.is_refused = false;
      } catch (const std::exception& error) {  // also of the system's, for want of room
        renewal.problems.push_back(error.what());
        renewal.kept.push_back(place.place.path);
      }
    }
  }

  /// The file that the user knows of a library.
  fs::path known_as(const fs::path& library) const {
    for (const Place& place : places_) {
      if (place.build.library == library) {
        return place.place.path;
      }
    }
    return library;
  }

  /// Adds the files, as the user knows them, in the place of which a host has older ones.
  void list_kept(const plugin::Report& report, const plugin::Report& before,
                 std::vector<fs::path>& kept) const {
    const auto former = [](const plugin::Report& of) {
      std::set<std::pair<std::size_t, fs::path>> files;
      for (std::size_t i = 0; i < of.directories.size(); ++i) {
        for (const plugin::FileReport& file : of.directories[i].files) {
          if (file.is_former) {
            files.emplace(i, file.path);
          }
        }
      }
      return files;
    };
    const auto known = former(before);
    for (const auto& [i, file] : former(report)) {
      if (!known.contains({i, file})) {
        kept.push_back(places_[i].build.library.empty() ? file : places_[i].place.path);
      }
    }
  }

 private:
  struct Place {
    plugin::SearchDirectory place;
    SourceBuild build;        // of a source; the last one that the compiler took
    bool is_refused = false;  // by the compiler, as it is now
  };

  static std::vector<fs::path> files_of(const Place& place) {
    const fs::path& path = place.place.path;
    if (place.build.library.empty()) {
      const auto is_library = [](const fs::path& file) { return file.extension() == ".so"; };
      return is_library(path) ? std::vector{path} : files_in(path, is_library);
    }
    std::vector<fs::path> files =
        files_in(path.parent_path().empty() ? "." : path.parent_path(), is_header);
    files.insert(files.end(), place.build.inputs.begin(), place.build.inputs.end());
    return files;
  }

  std::vector<Place> places_;
};

/// While it lives, this thread and those that it starts take no signals, but for those of errors
/// of their own: a handler that asks who is at work should be run by the thread that knows.
class NoSignals {
 public:
  NoSignals() {
    sigset_t signals;
    sigfillset(&signals);
    for (const int error : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) {
      sigdelset(&signals, error);
    }
    pthread_sigmask(SIG_SETMASK, &signals, &before_);
  }
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;

 private:
  sigset_t before_;
};

/// Both, in order, each once.
template <class Items>
void merge(Items& items, Items others) {
  for (auto& other : others) {
    if (std::find(items.begin(), items.end(), other) == items.end()) {
      items.push_back(std::move(other));
    }
  }
}

}  // namespace

class Watch::Impl {
 public:
  Impl(std::vector<plugin::SearchDirectory> places, std::chrono::milliseconds period)
      : places_(std::move(places)), period_(period) {
    seen_ = places_.look();  // first: what changes while it is loaded is noticed
    places_.refresh();       // what changed before that look
    in_use_ = std::make_shared<const plugin::Host>(places_.directories(), plugin::Loading::copies);
    const NoSignals for_the_thread;
    thread_ = std::thread([this] { follow(); });
  }
  ~Impl() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    wake_.notify_all();
    stop_.request_stop();
    thread_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  std::shared_ptr<const plugin::Host> in_use() const {
    const std::lock_guard lock(mutex_);
    return in_use_;
  }
  std::optional<Renewal> take() {
    if (!is_there_one_) {
      return std::nullopt;
    }
    const std::lock_guard lock(mutex_);
    is_there_one_ = false;
    return std::exchange(renewal_, std::nullopt);
  }
  void accept(std::shared_ptr<const plugin::Host> host) {
    const std::lock_guard lock(mutex_);
    in_use_.swap(host);
  }

 private:
  void follow() {
    constexpr int kPause = 25;  // periods after a failure
    Sight last = seen_;
    std::string told;
    for (bool failed = false;;) {
      {
        std::unique_lock lock(mutex_);
        if (wake_.wait_for(lock, failed ? kPause * period_ : period_, [this] { return ends_; })) {
          return;
        }
      }
      Sight now = places_.look();
      failed = failed && now != seen_;
      // Twice the same: whoever writes is done.
      if (now != seen_ && now == last) {
        try {
          renew(now);
          seen_ = now;
          told.clear();
          failed = false;
        } catch (const std::exception& error) {  // of the system: tried again, and told once
          failed = true;
          if (told != error.what()) {
            told = error.what();
            post({nullptr, {}, {told}, {}});
          }
        }
      }
      last = std::move(now);
    }
  }

  void renew(const Sight& now) {
    Renewal renewal;
    places_.rebuild(seen_, now, stop_.get_token(), renewal);
    if (stop_.stop_requested()) {
      return;
    }
    const std::shared_ptr<const plugin::Host> before = in_use();
    auto host = std::make_shared<const plugin::Host>(before->renewed(places_.directories()));
    const auto& known = before->report().warnings;
    for (const std::string& warning : host->report().warnings) {
      if (std::find(known.begin(), known.end(), warning) == known.end()) {
        renewal.problems.push_back(warning);
      }
    }
    places_.list_kept(host->report(), before->report(), renewal.kept);
    std::set<fs::path> files;
    for (const PluginKind kind : plugin::kPluginKinds) {
      for (const Declaration* declaration : host->all(kind)) {
        if (before->find(kind, declaration->name) != declaration) {
          files.insert(places_.known_as(host->file_of(kind, declaration->name)));
        }
      }
    }
    renewal.files.assign(files.begin(), files.end());
    if (!files.empty()) {
      renewal.host = std::move(host);
    }
    if (renewal.host || !renewal.problems.empty()) {
      post(std::move(renewal));
    } else {
      withdraw();
    }
  }

  /// Whoever takes it is told of what was not taken before, too. A new host has all that the one
  /// before it had; where there is none, that one is still the best.
  void post(Renewal renewal) {
    const std::lock_guard lock(mutex_);
    if (renewal_) {
      merge(renewal_->problems, std::move(renewal.problems));
      merge(renewal_->kept, std::move(renewal.kept));
      renewal.problems = std::move(renewal_->problems);
      renewal.kept = std::move(renewal_->kept);
      if (!renewal.host) {
        renewal.host = std::move(renewal_->host);
        renewal.files = std::move(renewal_->files);
      }
    }
    renewal_ = std::move(renewal);
    is_there_one_ = true;
  }

  /// All is as it was: a host that was not taken is out of date.
  void withdraw() {
    const std::lock_guard lock(mutex_);
    if (renewal_) {
      renewal_->host.reset();
      renewal_->files.clear();
    }
  }

  Places places_;  // the thread's, once it runs
  Sight seen_;     // likewise
  const std::chrono::milliseconds period_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::stop_source stop_;  // of the compiler
  bool ends_ = false;      // under the lock, as the next two
  std::shared_ptr<const plugin::Host> in_use_;
  std::optional<Renewal> renewal_;
  std::atomic<bool> is_there_one_{false};
  std::thread thread_;
};

Watch::Watch(std::vector<plugin::SearchDirectory> places, std::chrono::milliseconds period)
    : impl_(std::make_unique<Impl>(std::move(places), period)) {}
Watch::~Watch() = default;

const plugin::Host& Watch::host() const { return *impl_->in_use(); }
std::optional<Renewal> Watch::take() { return impl_->take(); }
void Watch::accept(Renewal renewal) {
  if (renewal.host) {
    impl_->accept(std::move(renewal.host));
  }
}

}  // namespace elsie::build
