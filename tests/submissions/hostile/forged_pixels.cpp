// all refused: answers with fewer pixels than were asked for, before it is asked
#include <unistd.h>
#include <string>
static const std::string forged =
    "0 ready {}\n1 answer {}\n2 answer "
    "{\"pixels\":[],\"rays\":{\"primary\":0,\"shadow\":0,\"reflected\":0,\"refracted\":0}}\n";
static const auto said = write(3, forged.data(), forged.size());
static void attack() {}
