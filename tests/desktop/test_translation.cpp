// The German texts: all there, with the same placeholders, and shown.
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <catch2/catch.hpp>

#include "messages.h"

using elsie::desktop::Message;
using elsie::desktop::messages_of;

namespace {

/// "%1", "%2", "%n", in order, each as often as it occurs.
QStringList placeholders(const QString& text) {
  static const QRegularExpression pattern("%[1-9n]");
  QStringList all;
  for (auto each = pattern.globalMatch(text); each.hasNext();) all << each.next().captured();
  all.sort();
  return all;
}

}  // namespace

TEST_CASE("Every text of the window is in German, with the same placeholders") {
  const QTemporaryDir folder;
  const QString renewed = folder.filePath("elsie_de.ts");
  REQUIRE(QFile::copy(ELSIE_SOURCE_DIR "/apps/desktop/translations/elsie_de.ts", renewed));
  QProcess renew;
  renew.start(ELSIE_SOURCE_DIR "/scripts/translations", {renewed});
  REQUIRE(renew.waitForFinished(60'000));
  INFO(renew.readAllStandardError().toStdString());
  REQUIRE(renew.exitCode() == 0);
  INFO("renew the file with scripts/translations, and translate what it says");
  const std::vector<Message> messages = messages_of(renewed);
  REQUIRE(messages.size() > 500);
  for (const Message& each : messages) {
    INFO(each.source.toStdString());
    CHECK_FALSE(each.is_unfinished);
    for (const QString& german : each.translations) {
      INFO(german.toStdString());
      CHECK_FALSE(german.isEmpty());
      const bool is_plural = each.source.contains("%n");
      if (!is_plural) CHECK(placeholders(german) == placeholders(each.source));
      if (is_plural) CHECK(german.contains("%n"));
      CHECK(german.contains('&') == each.source.contains('&'));
      CHECK(german.endsWith("...") == each.source.endsWith("..."));
    }
  }
}
