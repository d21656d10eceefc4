// all does_not_compile: has a file of this machine put into its library
asm(".section .rodata\n.incbin \"/etc/passwd\"\n.text");
static void attack() {}
