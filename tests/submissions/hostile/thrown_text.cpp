// crashed: throws a text that would like to be read
#include <stdexcept>
static void attack() {
  throw std::runtime_error("\x1b[2J]]></script><script>document.title=1</script>\n::error::x\n=HYPERLINK(\"x\")\xff\xfe");
}
