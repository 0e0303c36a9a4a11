// Preloaded into programs under valgrind. Valgrind 3.19 says of every processor with AVX2 that it
// has the instruction rdtscp; where it has not, the timer that libhwy measures as it is loaded, and
// that nothing here uses, ends the program (illegal instruction).
namespace hwy::platform {

double TimerResolution() { return 1e-9; }

}  // namespace hwy::platform
