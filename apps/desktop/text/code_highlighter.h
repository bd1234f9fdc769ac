// Colours the C++ and the Python of plugins.
#pragma once

#include <QSyntaxHighlighter>
#include <QTextCharFormat>

class QPalette;

namespace elsie::desktop {

class CodeHighlighter : public QSyntaxHighlighter {
 public:
  enum class Language { cpp, python };

  explicit CodeHighlighter(QTextDocument* document) : QSyntaxHighlighter(document) {}

  void set_language(Language language);
  void use_palette(const QPalette& palette);
  /// Blanks of a Tab.
  int indent() const { return language_ == Language::cpp ? 2 : 4; }

 protected:
  void highlightBlock(const QString& text) override;

 private:
  Language language_ = Language::cpp;
  QTextCharFormat word_, string_, comment_, number_;
};

}  // namespace elsie::desktop
