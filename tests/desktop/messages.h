// The texts of the window and their translations, from a file of Qt's linguist.
#pragma once

#include <QFile>
#include <QStringList>
#include <QXmlStreamReader>
#include <vector>

#include <catch2/catch.hpp>

namespace elsie::desktop {

struct Message {
  QString source;
  QStringList translations;  // several of a plural
  bool is_unfinished = false;
};

inline std::vector<Message> messages_of(const QString& path) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  std::vector<Message> all;
  bool is_plural = false;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = xml.name();
    if (name == u"message") {
      all.emplace_back();
      is_plural = xml.attributes().value("numerus") == u"yes";
    }
    if (name == u"source") all.back().source = xml.readElementText();
    if (name == u"translation") {
      all.back().is_unfinished = xml.attributes().value("type") == u"unfinished";
      if (!is_plural) all.back().translations << xml.readElementText();
    }
    if (name == u"numerusform") all.back().translations << xml.readElementText();
  }
  REQUIRE_FALSE(xml.hasError());
  return all;
}

}  // namespace elsie::desktop
