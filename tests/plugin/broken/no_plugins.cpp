// A plugin library in which somebody forgot the declaration.
#include "elsie/api/behavior.h"
