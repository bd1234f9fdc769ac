#define CATCH_CONFIG_RUNNER
#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
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
  QApplication application(argc, argv);
  if (qEnvironmentVariableIsSet("ELSIE_PICTURE_DARK")) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(dark());
  }
  std::setlocale(LC_NUMERIC, "C");
  return Catch::Session().run(argc, argv);
}
