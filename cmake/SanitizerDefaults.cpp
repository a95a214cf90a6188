// This file is linked into every program that is built with the address sanitizer. Mesa closes its
// drivers at exit, and then the leak checker can neither walk their thread-local storage nor name
// what they leaked (hence intercept_tls_get_addr and dlclose); OSMesa keeps a few structures for
// the life of the process. The sanitizer keeps 16 MB of freed memory instead of 256, so that tests
// can see that a program needs constant memory.
#include <cstdlib>

extern "C" {

const char* __asan_default_options()
{
    return "intercept_tls_get_addr=0:quarantine_size_mb=16";
}

// A report is of little use without the stack that led to it.
const char* __ubsan_default_options()
{
    return "print_stacktrace=1";
}

// Tests compare what a program writes to stderr, so the leak checker must add nothing to it.
const char* __lsan_default_options()
{
    return "print_suppressions=0";
}

// The checker is off for ranks under mpirun: OpenMPI leaves structures of its own behind, allocated
// through frames that the checker cannot walk, so no suppression names them all. A process without
// mpirun is always checked.
int __lsan_is_turned_off()
{
    return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr;
}

const char* __lsan_default_suppressions()
{
    // Mesa's compiler loses 112 bytes over a shader of OGRE's (valgrind sees that too).
    return "leak:libOSMesa.so\nleak:swrast_dri.so\n";
}

int dlclose(void*)
{
    return 0;
}
}
