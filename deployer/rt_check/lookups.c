/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/* Names of hosts, services, users and libraries: looked for in files, or on other computers. */
#include "in_front.h"

#include <dlfcn.h>
#include <grp.h>
#include <netdb.h>
#include <pwd.h>
#include <sys/socket.h>

typedef const struct addrinfo* Hints;
typedef const struct sockaddr* Address;
typedef struct hostent* Host;
typedef struct passwd* User;
typedef struct group* Group;

/* clang-format off */
OROFORGE_WATCH(SYSTEM_CALL, int, getaddrinfo, (const char* host, const char* service, Hints hints, struct addrinfo** found), (host, service, hints, found))
OROFORGE_WATCH(SYSTEM_CALL, int, getnameinfo, (Address a, socklen_t n, char* host, socklen_t h, char* service, socklen_t s, int flags), (a, n, host, h, service, s, flags))
OROFORGE_WATCH(SYSTEM_CALL, Host, gethostbyname, (const char* name), (name))
OROFORGE_WATCH(SYSTEM_CALL, Host, gethostbyname2, (const char* name, int family), (name, family))
OROFORGE_WATCH(SYSTEM_CALL, Host, gethostbyaddr, (const void* a, socklen_t n, int family), (a, n, family))
OROFORGE_WATCH(SYSTEM_CALL, int, gethostbyname_r, (const char* name, Host to, char* room, size_t size, Host* found, int* error), (name, to, room, size, found, error))
OROFORGE_WATCH(SYSTEM_CALL, struct servent*, getservbyname, (const char* name, const char* protocol), (name, protocol))
OROFORGE_WATCH(SYSTEM_CALL, User, getpwnam, (const char* name), (name))
OROFORGE_WATCH(SYSTEM_CALL, User, getpwuid, (uid_t user), (user))
OROFORGE_WATCH(SYSTEM_CALL, int, getpwnam_r, (const char* name, User to, char* room, size_t size, User* found), (name, to, room, size, found))
OROFORGE_WATCH(SYSTEM_CALL, int, getpwuid_r, (uid_t user, User to, char* room, size_t size, User* found), (user, to, room, size, found))
OROFORGE_WATCH(SYSTEM_CALL, Group, getgrnam, (const char* name), (name))
OROFORGE_WATCH(SYSTEM_CALL, Group, getgrgid, (gid_t group), (group))
/* clang-format on */

/* The loader goes by who calls it: its RUNPATH, its $ORIGIN. So the call is the last thing done, and what the loader allocates
   is counted as well. Not by the compiler's leave: optimizing or not, it is to be a jump. */
#ifdef __clang__
#define OROFORGE_JUMPS
#define OROFORGE_JUMP __attribute__((musttail))
#else
#define OROFORGE_JUMPS __attribute__((optimize("O2")))
#define OROFORGE_JUMP
#endif
OROFORGE_JUMPS OROFORGE_IN_FRONT void* dlopen(const char* file, int mode) {
    const __typeof__(&dlopen) next_ = OROFORGE_NEXT_OF(dlopen, 0);
    if (oroforge_rt_watching()) oroforge_rt_note(OROFORGE_RT_SYSTEM_CALL, "dlopen", __builtin_return_address(0));
    OROFORGE_JUMP return next_(file, mode);
}
