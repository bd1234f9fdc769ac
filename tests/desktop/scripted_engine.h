// A program in the place of elsie that answers orders as a test has written it down: for what the
// real one does not do, or only once in a long time.
#pragma once

#include <QFile>
#include <QFileInfo>
#include <QString>
#include <QTemporaryDir>

#include <catch2/catch.hpp>

#include "main_window.h"
#include "waiting.h"

namespace elsie::desktop {

class ScriptedEngine {
 public:
  /// `cases`: of a shell's `case` over the order's name. say() sends a message; $id is the order's.
  /// Without one of its own, an order is answered with nothing but its id.
  explicit ScriptedEngine(const QString& cases) {
    QFile file(program());
    REQUIRE(file.open(QIODevice::WriteOnly));
    file.write(R"(#!/bin/bash
say() { printf '%s\n' "$1" >&150; }
world='"text":"<world/>","tree":{"name":"world","line":1,"attributes":{}}'
scene='"scene":{"arena":[4,4],"bodies":[],"shapes":[],"views":[]}'
echo started >> "$(dirname "$0")/starts"
while IFS= read -r line <&150; do
  [[ $line =~ \"id\":([0-9]+) ]] && id=${BASH_REMATCH[1]}
  [[ $line =~ \"do\":\"([a-z_]+)\" ]] && order=${BASH_REMATCH[1]}
  case $order in
)" + cases.toUtf8() +
               R"(
    catalog) say "{\"answer\":$id,\"elements\":{},\"plugins\":[]}" ;;
    *) say "{\"answer\":$id}" ;;
  esac
done
)");
    file.close();
    REQUIRE(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
  }

  QString program() const { return folder_.filePath("elsie"); }
  QString folder() const { return folder_.path(); }
  /// How often it was started.
  qsizetype starts() const {
    QFile file(folder_.filePath("starts"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().count('\n') : 0;
  }

 private:
  QTemporaryDir folder_;
};

/// An answer to "open" that any window takes.
inline constexpr const char* kOpens = R"(open) say "{\"answer\":$id,$world,$scene,\"epoch\":1}" ;;)"
                                      "\n";

/// A window with such an engine.
class ScriptedWindow : public MainWindow {
 public:
  explicit ScriptedWindow(const ScriptedEngine& elsie) : MainWindow(elsie.program(), {}) { show(); }
  void open_world() {
    workbench().open_text("<world/>", {});
    REQUIRE(wait_for([&] { return workbench().is_right(); }));
  }
};

}  // namespace elsie::desktop
