// What the leak checker of the builds with sanitizers is not to report. When a step of ODE is left
// half way, as it is when physics fails, ODE loses the records of its jobs, 80 bytes each.
// fontconfig keeps the fonts that it has found for the life of the process.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's name
extern "C" const char* __lsan_default_suppressions() {
  return "leak:PreallocateJobInfos\nleak:dxtemplateThreadingImplementation\nleak:libfontconfig\n";
}
