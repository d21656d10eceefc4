// right: would like to phone home
#include <arpa/inet.h>
#include <sys/socket.h>
#include <cstdlib>
static void attack() {
  for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK})
    for (const int type : {SOCK_STREAM, SOCK_DGRAM, SOCK_RAW})
      if (socket(family, type, 0) >= 0) std::abort();
}
