#include "look/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <clocale>

namespace elsie::desktop {
namespace {

constexpr auto kLanguageSetting = "language";

QString folder() { return QCoreApplication::applicationDirPath() + "/../share/elsie/translations"; }

bool install(const QLocale& locale, const QString& name, const QString& from) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (translator->load(locale, name, "_", from)) {
    return QCoreApplication::installTranslator(translator);
  }
  delete translator;
  return false;
}

}  // namespace

QStringList languages() {
  QStringList codes{"en"};
  for (const QString& file : QDir(folder()).entryList({"elsie_*.qm"}, QDir::Files, QDir::Name)) {
    codes << file.section('_', 1).remove(".qm");
  }
  return codes;
}

QString name_of_language(const QString& code) {
  return code == "en" ? QStringLiteral("English") : QLocale(code).nativeLanguageName();
}

QString language() {
  const QString chosen = QSettings().value(kLanguageSetting).toString();
  return languages().contains(chosen) ? chosen : QStringLiteral("system");
}

void choose_language(const QString& code) { QSettings().setValue(kLanguageSetting, code); }

void begin_language() {
  std::setlocale(LC_NUMERIC, "C");  // Qt sets the user's, in which 1.5 may be read as 15
  const QLocale locale = language() == "system" ? QLocale() : QLocale(language());
  if (locale.language() == QLocale::English) {
    return;  // the texts in the sources
  }
  if (install(locale, "elsie", folder())) {  // not only half a window
    install(locale, "qtbase", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  }
}

}  // namespace elsie::desktop
