#include "look/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QHash>
#include <QLibraryInfo>
#include <QLocale>
#include <QMutex>
#include <QSettings>
#include <QTranslator>
#include <clocale>

namespace elsie::desktop {
namespace {

constexpr auto kLanguageSetting = "language";

QString folder() { return QCoreApplication::applicationDirPath() + "/../share/elsie/translations"; }

[[maybe_unused]] constexpr const char* kLanguages[] = {
    QT_TRANSLATE_NOOP("Languages", "English"),
    QT_TRANSLATE_NOOP("Languages", "German"),
};

/// What was translated, so that commands are found by their English words, too.
class EnglishTexts {
 public:
  void note(const QString& translated, const char* english) {
    const QMutexLocker lock(&mutex_);  // any thread may translate
    english_[plain(translated)] = QString::fromUtf8(english);
  }
  QString of(const QString& text) const {
    const QMutexLocker lock(&mutex_);
    return english_.value(plain(text), text);
  }

 private:
  static QString plain(QString text) { return text.remove('&').remove("...").toLower(); }

  mutable QMutex mutex_;
  QHash<QString, QString> english_;
};

EnglishTexts& english_texts() {
  static EnglishTexts texts;
  return texts;
}

class NotingTranslator : public QTranslator {
 public:
  using QTranslator::QTranslator;

  QString translate(const char* context, const char* english, const char* more,
                    int number) const override {
    const QString translated = QTranslator::translate(context, english, more, number);
    if (!translated.isEmpty()) english_texts().note(translated, english);
    return translated;
  }
};

bool install(const QLocale& locale, const QString& name, const QString& from) {
  auto* translator = new NotingTranslator(QCoreApplication::instance());
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

QStringList names_of_language(const QString& code) {
  const QString english = QLocale::languageToString(QLocale(code).language());
  return {code == "en" ? english : QLocale(code).nativeLanguageName(),
          QCoreApplication::translate("Languages", english.toUtf8().constData()), english};
}

QString english_of(const QString& text) { return english_texts().of(text); }

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
