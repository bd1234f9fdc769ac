// Opens a world in a session, edits it, and watches its run: ./session ELSIE WORLD EDIT
#include <fstream>
#include <iostream>
#include <iterator>

#include <poll.h>

#include <elsie/client/connection.h>

using elsie::client::Json;

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: session ELSIE WORLD EDIT\n";
    return 2;
  }
  std::ifstream file(argv[2]);
  const std::string text(std::istreambuf_iterator<char>(file), {});

  elsie::client::Connection session(argv[1]);
  session.send({{"id", 1}, {"do", "open"}, {"text", text}, {"file", argv[2]}});
  session.send({{"id", 2}, {"do", "edit"}, {"edits", {argv[3]}}});
  session.send({{"id", 3}, {"do", "run"}});

  std::size_t snapshots = 0;
  while (!session.ended()) {
    pollfd waiting{session.descriptor(), POLLIN, 0};
    poll(&waiting, 1, 16);  // about sixty times a second
    if (const auto snapshot = session.snapshots().take()) {
      ++snapshots;
    }
    for (const Json& message : session.receive()) {
      if (message.contains("refused")) {
        std::cerr << message["refused"][0]["message"].get<std::string>() << '\n';
        return 2;
      }
      if (message.value("event", "") == "ended") {
        std::cout << message["outcome"].get<std::string>() << ' '
                  << message["state_hash"].get<std::string>() << '\n';
        return snapshots > 0 ? 0 : 1;
      }
    }
  }
  std::cerr << session.ended()->report;  // a plugin ended the process
  return 3;
}
