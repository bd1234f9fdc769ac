#include "graph_file.h"

#include "elsie/files/write_whole.h"

#include "command.h"
#include "output_files.h"

namespace elsie::program {

GraphFile::GraphFile(const std::string& option) {
  const std::size_t equals = option.find('=');
  if (equals == 0) throw BadInput("--graph " + option + ": the robot's id is missing");
  if (equals != std::string::npos) robot_ = option.substr(0, equals);
  file_ = option.substr(equals == std::string::npos ? 0 : equals + 1);
  require_picture(file_, "--graph");
  file_ = std::filesystem::absolute(file_);
}

void GraphFile::save(const std::vector<picture::NamedGraph>& graphs,
                     const picture::GraphLights& lights, const std::string& robot,
                     const std::string& line) const {
  const std::string format = file_.extension().string().substr(1);
  files::write_whole_or_throw(
      file_, picture::draw_graphs(picture::lay_out(graphs), lights, robot + ": " + line, format));
}

}  // namespace elsie::program
