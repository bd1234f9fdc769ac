#include <algorithm>
#include <filesystem>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/number_text.h"
#include "elsie/editing/between.h"
#include "elsie/simulation/edit.h"
#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/tree.h"

#include "described.h"
#include "scene.h"
#include "server_impl.h"
#include "words.h"

namespace elsie::server {
namespace {

std::vector<simulation::Edit> edits_of(const std::vector<std::string>& edits) {
  std::vector<simulation::Edit> changes;
  for (const std::string& edit : edits) {
    const std::size_t equals = world::end_of_path(edit);
    changes.push_back({edit.substr(0, equals),
                       equals == std::string::npos ? std::string() : edit.substr(equals + 1)});
  }
  return changes;
}

/// Whether these edits of a document have the same meaning in its run, which has no templates, and
/// what layouts draw instead of these. In edits made together there, numbers in paths count removed
/// elements, too.
bool are_of_run(const std::vector<std::string>& edits, const world::World& world) {
  return !edits.empty() && !world.drawn &&
         std::none_of(edits.begin(), edits.end(), [&](const std::string& edit) {
           return world::concern_of(edit) == world::Concern::templates ||
                  world::is_about_layouts(edit) ||
                  (edits.size() > 1 && edits_of({edit}).front().path.ends_with("@remove"));
         });
}

std::filesystem::path folder_of(const std::string& file) {
  return std::filesystem::path(file).parent_path();
}

/// Whether reading this text, which was refused, may have created plugins, which can leave threads
/// behind.
bool may_make_plugins(const std::string& text) {
  try {
    const world::Element root = world::parse_markup(text, "");
    return root.child("robots") || root.child("measures") || root.child("changes");
  } catch (const world::WorldError&) {
    return false;  // no plugin is created for a text that cannot be read
  }
}

}  // namespace

world::ReadOptions Server::Impl::reading(std::uint64_t seed) const {
  world::ReadOptions options;
  options.data_directories = options_.data_directories;
  options.check_plugins = true;
  options.seed = seed;
  return options;
}

void Server::Impl::open(const Json& message, Json& answer) {
  const std::uint64_t seed = whole_number(message, "seed", seed_);
  const auto text = message.at("text").get<std::string>();
  auto document = [&] {
    try {
      return editing::Document(text, message.value("file", std::string()), host(), reading(seed));
    } catch (const world::WorldError&) {
      answer["made_plugins"] = may_make_plugins(text);
      throw;
    }
  }();
  auto simulation = simulation_of(document.world(), seed, host());
  document_ = std::move(document);
  seed_ = seed;
  begin(std::move(simulation));
  describe(answer);
}

void Server::Impl::edit(const Json& message, Json& answer) {
  const auto edits = message.at("edits").get<std::vector<std::string>>();
  // Objects of a run that is under way keep their names.
  const auto names = phase_ == Phase::under_way ? editing::Names::all : editing::Names::used;
  try {
    change([&] { document_->apply(edits, names); }, edits, answer);
  } catch (const base::FileError& error) {
    std::vector<base::Problem> problems = error.problems();
    for (base::Problem& each : problems) {
      each.message = without_edits(std::move(each.message), edits);
    }
    throw base::FileError(std::move(problems));
  }
}

void Server::Impl::become(const Json& message, Json& answer) {
  const std::string text =
      from_elsewhere(message.at("text").get<std::string>(), message.value("file", std::string()));
  change([&] { document_->become(text); }, {}, answer);
}

void Server::Impl::text_for(const Json& message, Json& answer) {
  const std::filesystem::path file(message.at("file").get<std::string>());
  answer["text"] = document_->text_for(file.parent_path().string());
}

// The run continues: the files that it has read do not change.
void Server::Impl::move(const Json& message, Json& answer) {
  const auto file = message.at("file").get<std::string>();
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const std::string before = document_->text(), begun = repetition_.text();
  const std::string old_file = document_->file();
  editing::Document moved(document_->text_for(folder), file, host(), reading(seed_));
  const std::string begun_there =
      begun == before ? moved.text() : adapted(begun, old_file, folder_of(file));
  document_ = std::move(moved);
  repetition_.move(file, begun_there);
  describe(answer);
}

std::string Server::Impl::from_elsewhere(const std::string& text, const std::string& file) const {
  return file.empty() ? text : adapted(text, file, folder_of(document_->file()));
}

std::string Server::Impl::adapted(const std::string& text, const std::string& file,
                                  const std::filesystem::path& folder) const {
  return folder_of(file) == folder
             ? text
             : editing::Document(text, file, host(), reading(seed_)).text_for(folder.string());
}

void Server::Impl::ping(const Json&, Json&) {}

void Server::Impl::catalog(const Json&, Json& answer) { answer.update(catalog_json(host())); }

void Server::Impl::change(const std::function<void()>& make, const std::vector<std::string>& edits,
                          Json& answer) {
  const std::string text_before = document_->text();
  std::optional<world::World> before, before_there;
  if (phase_ == Phase::under_way) {
    before = document_->world();
    before_there = world_of_run();
  }
  make();
  try {
    if (phase_ != Phase::under_way) {
      restart(seed_);
    } else {
      const std::vector<std::string> made =
          are_of_run(edits, *before) ? edits : editing::edits_between(*before, document_->world());
      change_run(before_there ? editing::edits_between(*before_there, *world_of_run()) : made,
                 made);
    }
  } catch (...) {
    document_->become(text_before);
    throw;
  }
  describe(answer);
}

std::optional<world::World> Server::Impl::world_of_run() const {
  const std::string folder = folder_of(run_file_).string();
  if (folder_of(document_->file()) == folder) {
    return std::nullopt;
  }
  return editing::Document(document_->text_for(folder), run_file_, host(), reading(seed_)).world();
}

void Server::Impl::change_run(const std::vector<std::string>& edits_there,
                              const std::vector<std::string>& edits) {
  if (edits_there.empty()) {
    return;
  }
  // `elsie run` takes no edit after the end of a run, so that no command would repeat what follows.
  if (const double end_s = document_->world().limits.time; end_s <= simulation_->time_s()) {
    throw base::BadInput("limits/@time would be " + base::number_text(end_s) +
                         " s, but the run is at " + base::number_text(simulation_->time_s(), 9) +
                         " s already; expected a later time");
  }
  try {
    simulation_->edit(edits_of(edits_there));
  } catch (const simulation::EditRefused& refused) {
    throw base::BadInput(refusal_in_words(refused.what(), edits_there));
  }
  ++epoch_;
  past_.replaced(*simulation_);
  standstills_.begin();
  marks_.forget_failures();
  repetition_.add(simulation_->time_s(), simulation_->world().physics.step, edits);
  if (!running_) {
    show();
  }
}

void Server::Impl::describe(Json& answer) {
  answer["epoch"] = epoch_;
  answer["text"] = document_->text();
  answer["tree"] = tree_json(*document_);
  answer["scene"] = scene_json(next_ ? *next_ : *simulation_);
  answer["warnings"] = warnings_json(document_->world());
}

}  // namespace elsie::server
