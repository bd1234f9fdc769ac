// Colours the C++ and the Python of plugins.
#pragma once

#include "text/highlighter.h"

namespace elsie::desktop {

class CodeHighlighter : public Highlighter {
 public:
  enum class Language { cpp, python };

  using Highlighter::Highlighter;

  void set_language(Language language);
  /// Blanks of a Tab.
  int indent() const { return language_ == Language::cpp ? 2 : 4; }

 protected:
  void highlightBlock(const QString& text) override;

 private:
  Language language_ = Language::cpp;
};

}  // namespace elsie::desktop
