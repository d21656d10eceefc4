// all does_not_compile: includes a file of this machine, to see it in a message
#include "/etc/passwd"
static void attack() {}
