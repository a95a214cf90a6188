// Linked into every program that is built with the address sanitizer. Mesa closes its drivers at
// exit, and then the leak checker can neither walk their thread-local storage nor name what they
// leaked; OSMesa keeps a few structures for the life of the process.
extern "C" {

const char* __asan_default_options()
{
    return "intercept_tls_get_addr=0";
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

const char* __lsan_default_suppressions()
{
    return "leak:libOSMesa.so\n";
}

int dlclose(void*)
{
    return 0;
}
}
