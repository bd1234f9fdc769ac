// elsie/python.so: has a Python interpreter run plugins, for the core.
//
// In a process of Python (`import elsie`) that is the process's own. Another process gets one when
// it meets its first script: libpython is opened here with its symbols visible to all, as Python's
// extension modules want it. Everything else is in the module elsie._elsie.
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include <dlfcn.h>

#include "elsie/api/registration.h"
#include "elsie/plugin/script.h"

namespace {

namespace fs = std::filesystem;

/// A function of Python's C interface, whose objects are pointers.
template <class Function>
Function* c_function(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// Takes the interpreter's lock while it lives.
class Lock {
 public:
  Lock() : state_(c_function<int()>("PyGILState_Ensure")()) {}
  ~Lock() { c_function<void(int)>("PyGILState_Release")(state_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int state_;
};

/// What Python says of the present exception.
std::string exception_text() {
  void *type = nullptr, *value = nullptr, *trace = nullptr;
  c_function<void(void**, void**, void**)>("PyErr_Fetch")(&type, &value, &trace);
  void* const text = value ? c_function<void*(void*)>("PyObject_Str")(value) : nullptr;
  const char* const words =
      text ? c_function<const char*(void*)>("PyUnicode_AsUTF8")(text) : nullptr;
  return words ? words : "an error without a text";
}

/// The folder with the package `elsie` that belongs to this library: below it when Elsie is built
/// or installed, around it in a wheel. Empty: it is not there.
fs::path package_folder() {
  Dl_info info{};
  static const char here = 0;
  if (dladdr(&here, &info) == 0 || !info.dli_fname) return {};
  const fs::path own = fs::weakly_canonical(info.dli_fname).parent_path();
  for (const char* const way : {"../python3/dist-packages", "../../../.."}) {
    std::error_code error;
    const fs::path folder = (own / way).lexically_normal();
    if (fs::exists(folder / "elsie" / ELSIE_PYTHON_PACKAGE, error)) return folder;
  }
  return {};
}

/// Starts an interpreter if the process has none. Returns a sentence if there is none to start.
std::string start() {
  if (!dlsym(RTLD_DEFAULT, "Py_IsInitialized") &&
      !dlopen(ELSIE_PYTHON_LIBRARY, RTLD_NOW | RTLD_GLOBAL)) {
    const std::string name = ELSIE_PYTHON_LIBRARY;
    return "there is no " + name + " here (Debian's package " + name.substr(0, name.find(".so")) +
           ")";
  }
  if (c_function<int()>("Py_IsInitialized")() != 0) return "";
  setenv("OPENBLAS_NUM_THREADS", "1", 0);  // numpy's sums must not depend on the machine
  // Sets and dictionaries have the same order in every process.
  constexpr const char* kHashSeed = "PYTHONHASHSEED";
  const char* const before = std::getenv(kHashSeed);
  const std::optional<std::string> kept =
      before ? std::optional<std::string>(before) : std::nullopt;
  setenv(kHashSeed, "0", 1);
  // Where Python looks for its packages follows from the interpreter that it takes itself for.
  static std::wstring interpreter;  // Python keeps its address
  const char* const chosen = std::getenv("ELSIE_PYTHON");
  if (auto* const name_it = c_function<void(const wchar_t*)>("Py_SetProgramName");
      chosen && *chosen && name_it) {
    const std::string text = chosen;
    interpreter.assign(text.begin(), text.end());
    name_it(interpreter.c_str());
  }
  c_function<void(int)>("Py_InitializeEx")(0);  // without handlers of signals
  kept ? setenv(kHashSeed, kept->c_str(), 1) : unsetenv(kHashSeed);
  // Output goes out line by line, because nobody ends the interpreter.
  c_function<int(const char*)>("PyRun_SimpleString")(
      "import sys\n"
      "for stream in (sys.stdout, sys.stderr):\n"
      "    if stream is not None: stream.reconfigure(line_buffering=True)\n");
  c_function<void*()>("PyEval_SaveThread")();
  return "";
}

/// The function of elsie._elsie that loads scripts.
elsie::plugin::LoadScript loader() {
  const Lock lock;
  const fs::path folder = package_folder();
  if (!folder.empty()) {
    void* const path = c_function<void*(const char*)>("PySys_GetObject")("path");
    void* const entry = c_function<void*(const char*)>("PyUnicode_FromString")(folder.c_str());
    if (c_function<int(void*, void*)>("PySequence_Contains")(path, entry) == 0) {
      c_function<int(void*, long, void*)>("PyList_Insert")(path, 0, entry);
    }
  }
  void* const module = c_function<void*(const char*)>("PyImport_ImportModule")("elsie._elsie");
  void* const capsule = module ? c_function<void*(void*, const char*)>("PyObject_GetAttrString")(
                                     module, "load_script")
                               : nullptr;
  void* const found = capsule ? c_function<void*(void*, const char*)>("PyCapsule_GetPointer")(
                                    capsule, ELSIE_LOAD_SCRIPT)
                              : nullptr;
  if (!found) {
    throw std::runtime_error(
        "needs the module elsie of Python, which cannot be imported: " + exception_text() +
        "; ELSIE_PYTHON may name the interpreter whose packages it uses");
  }
  return reinterpret_cast<elsie::plugin::LoadScript>(found);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void elsie_load_script(
    const fs::path& file, elsie::plugin::Script& script) {
  static const std::string missing = start();
  script.missing = missing;
  if (!missing.empty()) return;
  static std::atomic<elsie::plugin::LoadScript> load = nullptr;
  if (!load) load = loader();
  load.load()(file, script);
}
