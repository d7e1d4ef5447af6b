/* ORO_main in C. */
#include <rtt/os/main.h>

#include <stdio.h>

int ORO_main(int argc, char** argv)
{
    printf("argc %d, last %s\n", __os_main_argc(), argv[argc - 1]);
    return 7;
}
