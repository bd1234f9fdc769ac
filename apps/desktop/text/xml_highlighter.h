// Colours the XML of worlds.
#pragma once

#include "text/highlighter.h"

namespace elsie::desktop {

class XmlHighlighter : public Highlighter {
 public:
  using Highlighter::Highlighter;

 protected:
  void highlightBlock(const QString& text) override;
};

}  // namespace elsie::desktop
