#define CATCH_CONFIG_RUNNER
#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
#include <QTemporaryDir>
#include <clocale>

#include <catch2/catch.hpp>

namespace {

QPalette dark() {
  QPalette palette(QColor(53, 53, 53), QColor(42, 42, 42));
  palette.setColor(QPalette::Base, QColor(35, 35, 35));
  palette.setColor(QPalette::Highlight, QColor(42, 130, 218));
  return palette;
}

}  // namespace

int main(int argc, char** argv) {
  const QTemporaryDir own;  // settings, kept work and pictures: not those of the user
  const QString home = qEnvironmentVariable("ELSIE_TEST_HOME", own.path());
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
    qputenv(name, home.toUtf8());
  }
  QApplication application(argc, argv);
  if (qEnvironmentVariableIsSet("ELSIE_PICTURE_DARK")) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(dark());
  }
  QApplication::setOrganizationName("elsie");  // as the program does
  QApplication::setApplicationName("elsie-desktop");
  std::setlocale(LC_NUMERIC, "C");
  return Catch::Session().run(argc, argv);
}
