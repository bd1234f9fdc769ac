// The program itself, from its command line.
#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <catch2/catch.hpp>

namespace {

constexpr int kPatience_ms = 60'000;

QString program() { return QCoreApplication::applicationDirPath() + "/elsie-desktop"; }

QByteArray content_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The program, with settings of its own, and with a script in the place of elsie that notes how it
/// was started.
class Program {
 public:
  Program(const QStringList& arguments, const QStringList& environment = {}) {
    QFile script(folder_.filePath("elsie"));
    REQUIRE(script.open(QIODevice::WriteOnly));
    script.write(
        "#!/bin/sh\ncd \"$(dirname \"$0\")\"\n"
        "printf '%s\\n' \"$LP_NUM_THREADS\" \"$@\" > part\nmv part words\nexec sleep 600\n");
    script.close();
    REQUIRE(script.setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner));
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
      all.insert(name, folder_.path());
    }
    all.remove("LP_NUM_THREADS");
    for (const QString& each : environment) {
      all.insert(each.section('=', 0, 0), each.section('=', 1));
    }
    process_.setProcessEnvironment(all);
    process_.start(program(), QStringList{"--elsie", folder_.filePath("elsie")} + arguments);
  }
  ~Program() {
    process_.kill();
    process_.waitForFinished(kPatience_ms);
  }
  QProcess& process() { return process_; }
  /// What the engine was started with; before that, the threads of the renderer.
  QStringList words() {
    const QString file = folder_.filePath("words");
    REQUIRE(QTest::qWaitFor([&] { return QFile::exists(file); }, kPatience_ms));
    return QString::fromUtf8(content_of(file)).split('\n', Qt::SkipEmptyParts);
  }

 private:
  QTemporaryDir folder_;
  QProcess process_;
};

}  // namespace

TEST_CASE("The options of plugins reach the engine, those with a name that Qt has, too") {
  Program program({"--plugin", "a.so", "--plugin-path", "there", "--plugin=b.so", "world.xml"});
  CHECK(program.words() == QStringList{"1", "session", "--plugin-path", "there", "--plugin", "a.so",
                                       "--plugin", "b.so"});
}

TEST_CASE("A renderer in software has one thread, unless the user wishes more") {
  Program program({}, {"LP_NUM_THREADS=3"});
  CHECK(program.words() == QStringList{"3", "session"});
}

TEST_CASE("A wrong command line is refused with a sentence") {
  Program program({"one.xml", "two.xml"});
  REQUIRE(program.process().waitForFinished(kPatience_ms));
  CHECK(program.process().exitCode() == 2);
  CHECK(program.process().readAllStandardError().contains("expected one world, but found 2"));
}

TEST_CASE("An unknown option is refused with a sentence") {
  Program program({"--fullscreen"});
  REQUIRE(program.process().waitForFinished(kPatience_ms));
  CHECK(program.process().exitCode() == 2);
  const QByteArray said = program.process().readAllStandardError();
  CHECK(said.contains("elsie-desktop: Unknown option 'fullscreen'."));
  CHECK(said.contains("--help"));
}

TEST_CASE("Questions are answered without a display") {
  for (const char* question : {"--help", "--version"}) {
    Program program({question}, {"DISPLAY=", "WAYLAND_DISPLAY=", "QT_QPA_PLATFORM=xcb"});
    REQUIRE(program.process().waitForFinished(kPatience_ms));
    CHECK(program.process().exitStatus() == QProcess::NormalExit);
    CHECK(program.process().exitCode() == 0);
    CHECK(program.process().readAllStandardOutput().contains("elsie-desktop"));
  }
}
