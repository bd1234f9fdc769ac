// It has the note, but no entry point.
#include "elsie/api/abi.h"

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
