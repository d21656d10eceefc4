// all does_not_compile: defines what raylab itself defines
extern "C" __attribute__((visibility("default"))) const void* raylab_tasks_submission() { return nullptr; }
static void attack() {}
