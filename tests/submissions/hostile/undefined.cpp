// all does_not_compile: calls what is nowhere, which the linker tells with the names of its files
void nowhere();
static void attack() { nowhere(); }
