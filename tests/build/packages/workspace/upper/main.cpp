#include <rtt/os/main.h>

#include <cstdio>
int lowerNumber();
int upperNumber();
int ORO_main(int, char**) { return std::printf("lower %d, upper %d\n", lowerNumber(), upperNumber()) < 0; }
