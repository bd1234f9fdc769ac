#include "elsie/api/rule.h"

#include "elsie/base/number_text.h"

namespace elsie {

void WorldChanges::set(std::string path, double value) {
  edit(std::move(path), base::number_text(value));
}

}  // namespace elsie
