// elsie/python.so: has a Python interpreter run plugins, for the core.
//
// In a process of Python (`import elsie`) that is the process's own. Another process gets one when it meets its first
// script: libpython is opened here with its symbols visible to all, as Python's extension modules want it.
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>

#include <dlfcn.h>

#include "elsie/api/registration.h"
#include "elsie/plugin/own_library.h"
#include "elsie/plugin/script.h"
