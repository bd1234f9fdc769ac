#include <exception>
#include <filesystem>
#include <utility>

#include "elsie/simulation/fault.h"

#include "server_impl.h"

namespace elsie::server {
namespace {

Json names_of(const std::vector<std::filesystem::path>& files) {
  Json names = Json::array();
  for (const std::filesystem::path& file : files) {
    names.push_back(file.string());
  }
  return names;
}

}  // namespace

void Server::Impl::add_plugin(const Json& message, Json&) {
  const auto file = message.at("file").get<std::string>();
  plugins_.add(file);
  for (const char* const word : {"--plugin", file.c_str()}) {
    options_.plugin_options.emplace_back(word);
  }
}

void Server::Impl::renew_plugins() {
  auto renewal = plugins_.take();
  if (!renewal) {
    return;
  }
  Json event = {{"event", "plugins"},
                {"files", names_of(renewal->files)},
                {"problems", renewal->problems},
                {"kept", names_of(renewal->kept)},
                {"restored", names_of(renewal->restored)}};
  if (const auto host = renewal->host) {
    try {
      use(*host, event);
      plugins_.accept(*std::move(renewal));
      if (document_) {
        describe(event);
      }
    } catch (const simulation::PluginFault&) {
      throw;
    } catch (const std::exception& error) {
      event["kept"].insert(event["kept"].end(), event["files"].begin(), event["files"].end());
      event["files"].clear();
      event["problems"].push_back(error.what());
    }
  }
  link_.send(event);
  report_news();
  if (is_state_due_) {
    report_state();
  }
}

void Server::Impl::use(const plugin::Host& host, Json& event) {
  if (!document_) {
    return;
  }
  editing::Document document(document_->text(), document_->file(), host, reading(seed_));
  if (phase_ == Phase::ready) {
    auto simulation = simulation_of(document.world(), seed_, host);
    document_ = std::move(document);
    begin(std::move(simulation));
    return;
  }
  for (const std::string& note : simulation_->replace_plugins(host).notes) {
    event["problems"].push_back(note);
  }
  past_.replaced(*simulation_);
  standstills_.begin();
  marks_.forget_failures();
  document_ = std::move(document);
}

}  // namespace elsie::server
