// crashed: runs what is no instruction
static void attack() { __builtin_trap(); }
