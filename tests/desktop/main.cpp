#define CATCH_CONFIG_RUNNER
#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <catch2/catch.hpp>

#include "look/language.h"
#include "look/theme.h"

int main(int argc, char** argv) {
  const auto set_default = [](const char* name, const QString& value) {
    if (qEnvironmentVariableIsEmpty(name)) qputenv(name, value.toUtf8());
  };
  // What Mesa has compiled is kept for the next program, and plugins are not optimised, so that
  // little time goes to compilers.
  set_default("MESA_SHADER_CACHE_DIR",
              QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation));
  set_default("CXXFLAGS", "-O0");
  set_default("LP_NUM_THREADS", "1");  // as the program does
  const QTemporaryDir own;             // settings, kept work and pictures: not those of the user
  const QString home = qEnvironmentVariable("ELSIE_TEST_HOME", own.path());
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
    qputenv(name, home.toUtf8());
  }
  QApplication application(argc, argv);
  QApplication::setOrganizationName("elsie");  // as the program does
  QApplication::setApplicationName("elsie-desktop");
  elsie::desktop::choose_language(qEnvironmentVariable("ELSIE_TEST_LANGUAGE", "en"));
  elsie::desktop::begin_language();
  elsie::desktop::choose_theme(qEnvironmentVariable("ELSIE_TEST_THEME", "light"));
  elsie::desktop::begin_theme();
  return Catch::Session().run(argc, argv);
}
