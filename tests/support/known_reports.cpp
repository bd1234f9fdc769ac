// What the leak checker of the builds with sanitizers is not to report. When a step of ODE is left
// half way, as it is when physics fails, ODE loses the records of its jobs, 80 bytes each.
// fontconfig and Pango keep the fonts that they have found for the life of the process; Graphviz
// loses some of what it lays out.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's name
extern "C" const char* __lsan_default_suppressions() {
  return "leak:PreallocateJobInfos\nleak:dxtemplateThreadingImplementation\nleak:libfontconfig\n"
         "leak:libpango\nleak:libgobject\nleak:libglib\nleak:libgvc\nleak:libgvplugin\n"
         "leak:libcgraph\nleak:libcdt\n";
}

// What the thread sanitizer is not to look into. ODE keeps a pose that nobody uses for the next
// geom, of whatever thread, by an atomic exchange that the sanitizer does not see.
extern "C" const char* __tsan_default_suppressions();  // NOLINT: the sanitizer's name
extern "C" const char* __tsan_default_suppressions() { return "called_from_lib:libode.so\n"; }
