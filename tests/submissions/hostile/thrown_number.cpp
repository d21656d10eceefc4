// crashed: throws what is no exception
static void attack() { throw 1; }
