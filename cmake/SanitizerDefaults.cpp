// Linked into every program that is built with the address sanitizer. Mesa closes its drivers at
// exit, and then the leak checker can neither walk their thread-local storage nor name what they
// leaked; OSMesa keeps a few structures for the life of the process. Of what was freed 16 MB are
// kept, not 256: a program in constant memory shall be seen to be one.
#include <cstdlib>

extern "C" {

const char* __asan_default_options()
{
    return "intercept_tls_get_addr=0:quarantine_size_mb=16";
}

// A report without the way to it says little.
const char* __ubsan_default_options()
{
    return "print_stacktrace=1";
}

// Tests read what a program says on stderr.
const char* __lsan_default_options()
{
    return "print_suppressions=0";
}

// A rank under mpirun: OpenMPI leaves structures of its own behind, allocated through frames that
// the checker cannot walk, so no suppression names them all. A lone process is always checked.
int __lsan_is_turned_off()
{
    return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr;
}

const char* __lsan_default_suppressions()
{
    return "leak:libOSMesa.so\n";
}

int dlclose(void*)
{
    return 0;
}
}
