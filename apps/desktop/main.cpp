// elsie-desktop: the window of Elsie.
#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QMessageBox>
#include <algorithm>
#include <cstring>
#include <iostream>
#include <memory>
#include <vector>

#include "elsie/base/error.h"

#include "look/language.h"
#include "look/theme.h"
#include "main_window.h"

namespace {

constexpr int kBadInput = 2;

/// elsie is next to this program, both when installed and in a build folder.
QString program_beside() { return QCoreApplication::applicationDirPath() + "/elsie"; }

/// Removes `--plugin FILE` and `--plugin=FILE` from the arguments, because QApplication has an
/// option of that name and would keep them.
QStringList take_plugins(std::vector<char*>& arguments) {
  constexpr const char* kOption = "--plugin";
  const std::size_t length = std::strlen(kOption);
  QStringList taken;
  std::vector<char*> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const char* word = arguments[i];
    const bool is_option = std::strncmp(word, kOption, length) == 0;
    if (is_option && word[length] == '\0' && i + 1 < arguments.size()) {
      taken << kOption << QString::fromLocal8Bit(arguments[++i]);
    } else if (is_option && word[length] == '=') {
      taken << QString::fromLocal8Bit(word);
    } else {
      others.push_back(arguments[i]);
    }
  }
  arguments = std::move(others);
  return taken;
}

/// Whether the program is only asked something, which needs no display.
bool is_question(const std::vector<char*>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const char* word) {
    return word && QStringList{"-h", "--help", "--help-all", "-v", "--version"}.contains(word);
  });
}

std::unique_ptr<QCoreApplication> application_of(int& count, std::vector<char*>& arguments) {
  if (is_question(arguments)) {
    return std::make_unique<QCoreApplication>(count, arguments.data());
  }
  return std::make_unique<QApplication>(count, arguments.data());
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  const QStringList plugins = take_plugins(arguments);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  // Must come before a software renderer starts a thread for each processor: the processors are for
  // the simulation.
  if (!qEnvironmentVariableIsSet("LP_NUM_THREADS")) {
    qputenv("LP_NUM_THREADS", "1");
  }
  const auto application = application_of(count, arguments);
  QCoreApplication::setOrganizationName("elsie");
  QCoreApplication::setApplicationName("elsie-desktop");
  QCoreApplication::setApplicationVersion(ELSIE_VERSION);

  QCommandLineParser parser;
  parser.setApplicationDescription(
      "A window on worlds of behaviour-based robots: build, run, watch and change them.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("world", "World file to open", "[WORLD]");
  const QCommandLineOption plugin_path(
      "plugin-path", "Directory with plugin libraries, searched before all others; may be repeated",
      "DIR");
  const QCommandLineOption plugin(
      "plugin", "Plugin library, a plugin's one source file, or one in Python; may be repeated",
      "FILE");
  const QCommandLineOption elsie("elsie", "The program elsie, if it is not next to this one",
                                 "FILE");
  parser.addOptions({plugin_path, plugin, elsie});
  QStringList words = QCoreApplication::arguments();
  words = words.mid(0, 1) + plugins + words.mid(1);
  if (!parser.parse(words)) {
    std::cerr << "elsie-desktop: " << parser.errorText().toStdString()
              << " Run elsie-desktop --help for its options.\n";
    return kBadInput;
  }
  parser.process(words);  // answers questions

  QStringList options;
  for (const QString& each : parser.values(plugin_path)) options << "--plugin-path" << each;
  for (const QString& each : parser.values(plugin)) options << "--plugin" << each;
  const QString program = parser.isSet(elsie) ? parser.value(elsie) : program_beside();
  if (!QFileInfo(program).isExecutable()) {
    std::cerr << "elsie-desktop: '" << program.toStdString()
              << "' is not a program; reinstall Elsie, or name it with --elsie FILE\n";
    return kBadInput;
  }
  if (parser.positionalArguments().size() > 1) {
    std::cerr << "elsie-desktop: expected one world, but found "
              << parser.positionalArguments().size() << "; each window has one\n";
    return kBadInput;
  }
  QApplication::setApplicationDisplayName("Elsie");
  elsie::desktop::begin_language();
  elsie::desktop::begin_theme();
  try {
    elsie::desktop::MainWindow window(program, options);
    window.show();
    const QString world = parser.positionalArguments().value(0);
    if (!window.offer_recovered(world) && !world.isEmpty()) window.open(world);
    return QApplication::exec();
  } catch (const elsie::base::Error& error) {
    std::cerr << "elsie-desktop: " << error.what() << '\n';
    return error.exit_code();
  }
}
