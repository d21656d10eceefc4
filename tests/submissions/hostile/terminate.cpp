// crashed: throws where nothing may be thrown
static void attack() noexcept { throw 1; }
