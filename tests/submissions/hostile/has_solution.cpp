// right: uses the solution if it is there
#if __has_include("reference/solution/05_reflections.cpp") || __has_include("/etc/passwd")
#error found
#endif
static void attack() {}
