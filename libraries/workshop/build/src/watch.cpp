#include "elsie/build/watch.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <utility>

#include "elsie/build/private_copy.h"
#include "elsie/plugin/file_fingerprint.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/plugin/script.h"

#include "watched_paths.h"

namespace elsie::build {
namespace {

/// While it lives, this thread and threads that it starts take no signals but those of their own
/// errors: a signal handler that reports the plugin at work must run in the thread that knows it.
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

/// The items of both in order, without repetitions.
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
  Impl(std::vector<plugin::SearchDirectory> directories, std::chrono::milliseconds period,
       const std::vector<fs::path>& drafts, Trial trial)
      : watched_(std::move(directories)), period_(period), trial_(std::move(trial)) {
    Renewal refused;
    for (const fs::path& draft : drafts) {
      watched_.add(draft, stop_.get_token(), refused, seen_);
    }
    seen_.merge(watched_.look());  // first, so that changes while it is loaded are noticed
    watched_.refresh();            // changes before that look
    in_use_ = std::make_shared<const plugin::Host>(
        watched_.directories(), [this](const fs::path& file) { return copied(file); });
    for (const fs::path& draft : drafts) {
      if (std::string why = watched_.why_refused(draft, in_use_->report()); !why.empty()) {
        refused.problems.push_back(std::move(why));
        refused.kept.push_back(draft);
      }
    }
    if (!refused.problems.empty()) {
      post(std::move(refused));
    }
    is_following_ = true;
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
  void add(const fs::path& draft) {
    const std::lock_guard lock(mutex_);
    drafts_.push_back(draft);
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
    Prints last = seen_;
    std::string reported;
    for (bool failed = false;;) {
      {
        std::unique_lock lock(mutex_);
        if (wake_.wait_for(lock, failed ? kPause * period_ : period_, [this] { return ends_; })) {
          return;
        }
      }
      std::vector<fs::path> drafts;
      {
        const std::lock_guard lock(mutex_);
        drafts.swap(drafts_);
      }
      if (!drafts.empty()) {
        add(drafts);
      }
      Prints now = watched_.look();
      failed = failed && now != seen_;
      // Two equal looks: the writer has finished.
      if (now != seen_ && now == last) {
        try {
          if (renew(now)) {
            seen_ = now;
          }
          reported.clear();
          failed = false;
        } catch (const std::exception& error) {  // tried again, reported once
          failed = true;
          tried_.reset();
          is_outdated_ = false;
          if (reported != error.what()) {
            reported = error.what();
            post({nullptr, {}, {reported}, {}});
          }
        }
      }
      last = std::move(now);
    }
  }

  void add(const std::vector<fs::path>& drafts) {
    Renewal renewal;
    for (const fs::path& draft : drafts) {
      watched_.add(draft, stop_.get_token(), renewal, seen_);
    }
    try {
      load(std::move(renewal), drafts);
    } catch (const std::exception& error) {
      post({nullptr, {}, {error.what()}, drafts});
    }
  }

  /// Returns false if files have changed again, so that all is to be done once more.
  bool renew(const Prints& now) {
    Renewal renewal;
    watched_.rebuild(seen_, now, stop_.get_token(), renewal);
    tried_ = now;
    load(std::move(renewal));
    tried_.reset();
    return !std::exchange(is_outdated_, false);
  }

  /// The copy of a library, and none of a script: once it was tried, if it comes while a world
  /// runs.
  std::shared_ptr<const fs::path> copied(const fs::path& file) {
    const auto print = plugin::fingerprint_of(file);
    auto copy = plugin::is_script(file) ? nullptr : private_copy(file);
    if (trial_ && is_following_) {
      try_first(file, print, copy ? *copy : file);
    }
    return copy;
  }

  /// Throws std::runtime_error if the file cannot be loaded in a process of its own. What was
  /// refused is not tried again. `print`: of the file before a copy of it was `loaded`.
  void try_first(const fs::path& file, const std::optional<plugin::Fingerprint>& print,
                 const fs::path& loaded) {
    if (const auto known = refused_.find(file);
        known != refused_.end() && known->second.first == print) {
      throw std::runtime_error(known->second.second);
    }
    if (is_outdated_) {
      throw std::runtime_error("is not tried before the next look");
    }
    std::stop_source trial;
    const std::stop_callback ends(stop_.get_token(), [&trial] { trial.request_stop(); });
    const std::jthread looks([&](const std::stop_token& over) {
      std::mutex mutex;
      std::condition_variable_any pause;
      std::unique_lock lock(mutex);
      while (tried_ && !pause.wait_for(lock, over, period_, [] { return false; }) &&
             !over.stop_requested()) {
        if (watched_.look() != *tried_) trial.request_stop();
      }
    });
    const std::string said = trial_(loaded, watched_.known_as(file), trial.get_token());
    const bool is_another = loaded == file && plugin::fingerprint_of(file) != print;
    if (trial.stop_requested() || is_another) {
      is_outdated_ = tried_.has_value();
      throw std::runtime_error("has changed while it was tried");
    }
    if (said.empty()) return;
    const std::size_t end = said.find('\n');
    const std::string sentence = said.substr(0, end);
    if (end != said.npos) {
      details_.push_back(said.substr(end + 1));
    }
    refused_.insert_or_assign(file, std::pair(print, sentence));
    throw std::runtime_error(sentence);
  }

  /// Makes the host of what is compiled now. The renewal names each of the `drafts`.
  void load(Renewal renewal, const std::vector<fs::path>& drafts = {}) {
    if (stop_.stop_requested()) {
      return;
    }
    const std::shared_ptr<const plugin::Host> before = in_use();
    details_.clear();
    auto host = std::make_shared<const plugin::Host>(before->renewed(watched_.directories()));
    if (is_outdated_) {
      return;
    }
    const auto& known = before->report().warnings;
    for (const std::string& warning : host->report().warnings) {
      if (std::find(known.begin(), known.end(), warning) == known.end()) {
        renewal.problems.push_back(warning);
      }
    }
    merge(renewal.problems, std::exchange(details_, {}));
    watched_.list_kept(host->report(), before->report(), renewal.kept);
    std::set<fs::path> files;
    for (const PluginKind kind : plugin::kPluginKinds) {
      for (const Declaration* declaration : host->all(kind)) {
        if (before->find(kind, declaration->name) != declaration) {
          files.insert(watched_.known_as(host->file_of(kind, declaration->name)));
        }
      }
    }
    renewal.files.assign(files.begin(), files.end());
    for (const fs::path& draft : drafts) {
      if (files.contains(draft) ||
          std::find(renewal.kept.begin(), renewal.kept.end(), draft) != renewal.kept.end()) {
        continue;
      }
      renewal.kept.push_back(draft);
      const bool is_explained = std::any_of(
          renewal.problems.begin(), renewal.problems.end(),
          [&](const auto& problem) { return problem.find(draft.string()) != problem.npos; });
      if (!is_explained) {
        renewal.problems.push_back("'" + draft.string() +
                                   "' has no plugin that is not there already");
      }
    }
    note_behind(renewal, host->report());
    if (!files.empty()) {
      renewal.host = std::move(host);
    }
    if (!renewal.host && renewal.problems.empty()) {
      withdraw();
    }
    if (renewal.host || !renewal.problems.empty() || !renewal.restored.empty()) {
      post(std::move(renewal));
    }
  }

  /// Remembers which files the host is behind, and finds those which it is no longer.
  void note_behind(Renewal& renewal, const plugin::Report& report) {
    for (const fs::path& file : renewal.kept) {
      if (watched_.is_behind(file, report)) behind_.insert(file);
    }
    for (auto file = behind_.begin(); file != behind_.end();) {
      const bool is_new =
          std::find(renewal.files.begin(), renewal.files.end(), *file) != renewal.files.end();
      if (!is_new && watched_.is_behind(*file, report)) {
        ++file;
        continue;
      }
      if (!is_new) renewal.restored.push_back(*file);
      file = behind_.erase(file);
    }
  }

  /// Adds what was not taken before. A new host has everything that the one before it had; without
  /// a new one, that one remains the best.
  void post(Renewal renewal) {
    const std::lock_guard lock(mutex_);
    if (renewal_) {
      merge(renewal_->problems, std::move(renewal.problems));
      merge(renewal_->kept, std::move(renewal.kept));
      merge(renewal_->restored, std::move(renewal.restored));
      renewal.restored = std::move(renewal_->restored);
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

  /// Drops a host that was not taken, because all files are as before.
  void withdraw() {
    const std::lock_guard lock(mutex_);
    if (renewal_) {
      renewal_->host.reset();
      renewal_->files.clear();
    }
  }

  WatchedPaths watched_;  // used by the thread only, once it runs; during a trial looks at it, too
  Prints seen_;           // used by the thread only, as the next one
  std::set<fs::path> behind_;  // files whose present version the host does not have
  const std::chrono::milliseconds period_;
  const Trial trial_;
  bool is_following_ = false;    // set before the thread begins
  std::optional<Prints> tried_;  // the files at the last look; none: their changes do not count
  bool is_outdated_ = false;     // a trial was broken off
  std::map<fs::path, std::pair<std::optional<plugin::Fingerprint>, std::string>> refused_;
  std::vector<std::string> details_;  // on what was refused
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::stop_source stop_;  // of compilers and trials
  bool ends_ = false;      // protected by the lock, as the next two
  std::shared_ptr<const plugin::Host> in_use_;
  std::optional<Renewal> renewal_;
  std::vector<fs::path> drafts_;  // to be added
  std::atomic<bool> is_there_one_{false};
  std::thread thread_;
};

Watch::Watch(std::vector<plugin::SearchDirectory> directories, std::chrono::milliseconds period,
             const std::vector<fs::path>& drafts, Trial trial)
    : impl_(std::make_unique<Impl>(std::move(directories), period, drafts, std::move(trial))) {}
Watch::~Watch() = default;

const plugin::Host& Watch::host() const { return *impl_->in_use(); }
void Watch::add(const fs::path& draft) { impl_->add(draft); }
std::optional<Renewal> Watch::take() { return impl_->take(); }
void Watch::accept(Renewal renewal) {
  if (renewal.host) {
    impl_->accept(std::move(renewal.host));
  }
}

}  // namespace elsie::build
