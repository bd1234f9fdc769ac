#define CATCH_CONFIG_RUNNER
#include <QApplication>
#include <clocale>

#include <catch2/catch.hpp>

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  return Catch::Session().run(argc, argv);
}
