// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Each function that --rt-check stands in front of: it does what it is there for, and is counted once, as the fault that it
// is, if it may block.
#include "counted_calls.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <filesystem>
#include <string>
#include <thread>

#include <climits>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <malloc.h>
#include <netdb.h>
#include <poll.h>
#include <pthread.h>
#include <pwd.h>
#include <semaphore.h>
#include <spawn.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <threads.h>
#include <unistd.h>

namespace {

using rt_check_test::counted;

void* volatile block;
const timespec kSoon = {0, 1000}, kNow = {0, 0}, kPast = {1, 0};

TEST(Memory, IsCounted) {
    EXPECT_EQ("RTC001 malloc 1", counted([] { block = std::malloc(10); }));
    EXPECT_EQ("RTC001 realloc 1", counted([] { block = std::realloc(block, 10000); }));
    EXPECT_EQ("RTC001 reallocarray 1", counted([] { block = reallocarray(block, 10, 10); }));
    EXPECT_EQ("RTC002 free 1", counted([] { std::free(block); }));
    EXPECT_EQ("", counted([] { std::free(nullptr); }));
    EXPECT_EQ("RTC001 calloc 1", counted([] { block = std::calloc(10, 10); }));
    EXPECT_EQ(0, static_cast<char*>(block)[99]);
    std::free(block);
    EXPECT_EQ("RTC001 aligned_alloc 1", counted([] { block = std::aligned_alloc(256, 512); }));
    EXPECT_EQ(0u, reinterpret_cast<std::uintptr_t>(block) % 256);
    std::free(block);
    EXPECT_EQ("RTC001 memalign 1", counted([] { block = memalign(256, 512); }));
    std::free(block);
    EXPECT_EQ("RTC001 posix_memalign 1", counted([] {
                  void* made = nullptr;
                  EXPECT_EQ(0, posix_memalign(&made, 256, 512));
                  block = made;
              }));
    std::free(block);
    EXPECT_EQ("RTC001 malloc 1, RTC002 free 1", counted([] {
                  char* const made = new char[100];
                  block = made;
                  delete[] made;
              }));
    EXPECT_EQ("RTC001 malloc 1, RTC002 free 1", counted([] { std::free(block = strdup("text")); }));  // within libc
    EXPECT_EQ("RTC001 mmap 1, RTC002 munmap 1",
              counted([] { munmap(mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0), 4096); }));
}

TEST(Memory, OfPagesIsCounted) {
    constexpr int kAccess = PROT_READ, kFlags = MAP_PRIVATE | MAP_ANONYMOUS;
    EXPECT_EQ("RTC001 mmap64 1", counted([] { block = mmap64(nullptr, 4096, kAccess, kFlags, -1, 0); }));
    EXPECT_EQ("RTC001 mremap 1", counted([] { block = mremap(block, 4096, 8192, MREMAP_MAYMOVE); }));
    EXPECT_NE(MAP_FAILED, block);
    EXPECT_EQ("RTC001 mlock 1", counted([] { (void)mlock(block, 4096); }));
    munmap(block, 8192);
    EXPECT_EQ("RTC001 sbrk 1", counted([] { EXPECT_NE(nullptr, sbrk(0)); }));
}

TEST(Locks, AreCountedButNotAttempts) {
    static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    static pthread_rwlock_t lock = PTHREAD_RWLOCK_INITIALIZER;
    const auto unlock = [] { EXPECT_EQ(0, pthread_mutex_unlock(&mutex)); };
    const auto release = [] { EXPECT_EQ(0, pthread_rwlock_unlock(&lock)); };
    EXPECT_EQ("RTC003 pthread_mutex_lock 1", counted([&] { pthread_mutex_lock(&mutex), unlock(); }));
    EXPECT_EQ("RTC003 pthread_mutex_timedlock 1", counted([&] { pthread_mutex_timedlock(&mutex, &kPast), unlock(); }));
    EXPECT_EQ("RTC003 pthread_mutex_clocklock 1",
              counted([&] { pthread_mutex_clocklock(&mutex, CLOCK_MONOTONIC, &kPast), unlock(); }));
    EXPECT_EQ("", counted([&] { pthread_mutex_trylock(&mutex), unlock(); }));
    EXPECT_EQ("RTC003 pthread_rwlock_rdlock 1", counted([&] { pthread_rwlock_rdlock(&lock), release(); }));
    EXPECT_EQ("RTC003 pthread_rwlock_wrlock 1", counted([&] { pthread_rwlock_wrlock(&lock), release(); }));
    EXPECT_EQ("RTC003 pthread_rwlock_timedrdlock 1",
              counted([&] { pthread_rwlock_timedrdlock(&lock, &kPast), release(); }));
    EXPECT_EQ("RTC003 pthread_rwlock_timedwrlock 1",
              counted([&] { pthread_rwlock_timedwrlock(&lock, &kPast), release(); }));
    EXPECT_EQ("", counted([&] { pthread_rwlock_tryrdlock(&lock), release(); }));
    static pthread_spinlock_t spin;
    pthread_spin_init(&spin, PTHREAD_PROCESS_PRIVATE);
    EXPECT_EQ("RTC003 pthread_spin_lock 1", counted([] { pthread_spin_lock(&spin), pthread_spin_unlock(&spin); }));
    static mtx_t own;
    mtx_init(&own, mtx_plain);
    EXPECT_EQ("RTC003 mtx_lock 1", counted([] { mtx_lock(&own), mtx_unlock(&own); }));
}

TEST(Waits, ForThreadsAreCounted) {
    static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    static pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
    pthread_mutex_lock(&mutex);
    EXPECT_EQ("RTC004 pthread_cond_timedwait 1",
              counted([] { EXPECT_EQ(ETIMEDOUT, pthread_cond_timedwait(&condition, &mutex, &kPast)); }));
    EXPECT_EQ("RTC004 pthread_cond_clockwait 1", counted([] {
                  EXPECT_EQ(ETIMEDOUT, pthread_cond_clockwait(&condition, &mutex, CLOCK_MONOTONIC, &kPast));
              }));
    // One that is really woken: the wait is that of the present version, not of an old one.
    std::atomic<bool> woken{false};
    std::thread waker([&woken] {
        while (!woken) {
            pthread_mutex_lock(&mutex);
            pthread_cond_signal(&condition);
            pthread_mutex_unlock(&mutex);
        }
    });
    EXPECT_EQ("RTC004 pthread_cond_wait 1", counted([] { EXPECT_EQ(0, pthread_cond_wait(&condition, &mutex)); }));
    woken = true;
    pthread_mutex_unlock(&mutex);
    waker.join();
    static sem_t semaphore;
    sem_init(&semaphore, 0, 1);
    EXPECT_EQ("RTC004 sem_wait 1", counted([] { EXPECT_EQ(0, sem_wait(&semaphore)); }));
    EXPECT_EQ("RTC004 sem_timedwait 1", counted([] { EXPECT_EQ(-1, sem_timedwait(&semaphore, &kPast)); }));
    EXPECT_EQ("", counted([] { EXPECT_EQ(-1, sem_trywait(&semaphore)); }));
    static pthread_t thread;
    const auto nothing = [](void* value) { return value; };
    EXPECT_EQ("RTC004 pthread_join 1, RTC007 pthread_create 1", counted([&] {
                  void* result = nullptr;
                  EXPECT_EQ(0, pthread_create(&thread, nullptr, nothing, &mutex));
                  EXPECT_EQ(0, pthread_join(thread, &result));
                  EXPECT_EQ(&mutex, result);
              }));
    static std::atomic<int> word{1};
    EXPECT_EQ("RTC004 futex 1", counted([] { syscall(SYS_futex, &word, FUTEX_WAIT, 1, &kSoon, nullptr, 0); }));
    EXPECT_EQ("", counted([] { syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0); }));
    EXPECT_EQ("RTC004 syscall 1", counted([] { syscall(SYS_nanosleep, &kSoon, nullptr); }));
}

TEST(Waits, ForTimesAndDescriptorsAreCounted) {
    EXPECT_EQ("RTC004 nanosleep 1", counted([] { EXPECT_EQ(0, nanosleep(&kSoon, nullptr)); }));
    EXPECT_EQ("", counted([] { EXPECT_EQ(0, nanosleep(&kNow, nullptr)); }));
    EXPECT_EQ("RTC004 clock_nanosleep 1", counted([] { clock_nanosleep(CLOCK_MONOTONIC, 0, &kSoon, nullptr); }));
    EXPECT_EQ("RTC004 usleep 1", counted([] { usleep(1); }));
    EXPECT_EQ("RTC004 sleep 1", counted([] { sleep(0); }));
    EXPECT_EQ("RTC004 thrd_sleep 1", counted([] { thrd_sleep(&kSoon, nullptr); }));
    EXPECT_EQ("RTC004 poll 1", counted([] { EXPECT_EQ(0, poll(nullptr, 0, 1)); }));
    EXPECT_EQ("", counted([] { EXPECT_EQ(0, poll(nullptr, 0, 0)); }));
    EXPECT_EQ("RTC004 ppoll 1", counted([] { EXPECT_EQ(0, ppoll(nullptr, 0, &kSoon, nullptr)); }));
    EXPECT_EQ("", counted([] { EXPECT_EQ(0, ppoll(nullptr, 0, &kNow, nullptr)); }));
    timeval soon = {0, 1}, now = {0, 0};
    EXPECT_EQ("RTC004 select 1", counted([&] { EXPECT_EQ(0, select(0, nullptr, nullptr, nullptr, &soon)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(0, select(0, nullptr, nullptr, nullptr, &now)); }));
    EXPECT_EQ("RTC004 pselect 1", counted([] { pselect(0, nullptr, nullptr, nullptr, &kSoon, nullptr); }));
    const int events = epoll_create1(EPOLL_CLOEXEC);
    epoll_event event{};
    EXPECT_EQ("RTC004 epoll_wait 1", counted([&] { EXPECT_EQ(0, epoll_wait(events, &event, 1, 1)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(0, epoll_wait(events, &event, 1, 0)); }));
    close(events);
    sigset_t none;
    sigemptyset(&none);
    EXPECT_EQ("RTC004 sigtimedwait 1", counted([&] { sigtimedwait(&none, nullptr, &kSoon); }));
}

TEST(SystemCalls, OnFilesAreCounted) {
    char name[] = "/tmp/oroforge-calls-XXXXXX";
    static int file = -1;
    file = mkstemp(name);
    const std::string path = name;
    char bytes[8] = "1234567";
    iovec part = {bytes, 4};
    EXPECT_EQ("RTC005 write 1", counted([&] { EXPECT_EQ(8, write(file, bytes, 8)); }));
    EXPECT_EQ("RTC005 pread 1", counted([&] { EXPECT_EQ(4, pread(file, bytes + 4, 4, 0)); }));
    EXPECT_STREQ("12341234", std::string(bytes, 8).c_str());
    EXPECT_EQ("RTC005 pwrite 1", counted([&] { EXPECT_EQ(1, pwrite(file, "9", 1, 0)); }));
    EXPECT_EQ("RTC005 writev 1", counted([&] { EXPECT_EQ(4, writev(file, &part, 1)); }));
    EXPECT_EQ("RTC005 fsync 1", counted([] { EXPECT_EQ(0, fsync(file)); }));
    EXPECT_EQ("RTC005 fdatasync 1", counted([] { EXPECT_EQ(0, fdatasync(file)); }));
    EXPECT_EQ("RTC005 ftruncate 1", counted([] { EXPECT_EQ(0, ftruncate(file, 2)); }));
    EXPECT_EQ("RTC005 close 1", counted([] { EXPECT_EQ(0, close(file)); }));
    // What is no file's business has no effect on files.
    EXPECT_EQ("RTC005 open 1", counted([&] { file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); }));
    EXPECT_EQ("RTC005 read 1", counted([&] { EXPECT_EQ(2, read(file, bytes, 8)); }));
    close(file);
    EXPECT_EQ("RTC005 openat 1", counted([&] { file = openat(AT_FDCWD, path.c_str(), O_RDONLY | O_CLOEXEC); }));
    EXPECT_LE(0, file);
    close(file);
    struct stat status {};
    EXPECT_EQ("RTC005 stat 1", counted([&] { EXPECT_EQ(0, stat(path.c_str(), &status)); }));
    EXPECT_EQ(2, status.st_size);
    EXPECT_EQ("RTC005 access 1", counted([&] { EXPECT_EQ(0, access(path.c_str(), R_OK)); }));
    const std::string moved = path + "x";
    EXPECT_EQ("RTC005 rename 1", counted([&] { EXPECT_EQ(0, rename(path.c_str(), moved.c_str())); }));
    EXPECT_EQ("RTC005 unlink 1", counted([&] { EXPECT_EQ(0, unlink(moved.c_str())); }));
    EXPECT_EQ("RTC005 open 1", counted([&] { file = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600); }));
    EXPECT_TRUE(fstat(file, &status) == 0 && (status.st_mode & 0777) == 0600);
    close(file);
    unlink(path.c_str());
    EXPECT_EQ("RTC005 mkdir 1", counted([&] { EXPECT_EQ(0, mkdir(path.c_str(), 0700)); }));
    EXPECT_EQ("RTC005 rmdir 1", counted([&] { EXPECT_EQ(0, rmdir(path.c_str())); }));
}

TEST(SystemCalls, OnFilesWithLargeOffsetsAreCounted) {
    char name[] = "/tmp/oroforge-calls-XXXXXX";
    static int file = -1;
    file = mkstemp64(name);
    const std::string path = name;
    struct stat64 status {};
    EXPECT_EQ("RTC005 ftruncate64 1", counted([] { EXPECT_EQ(0, ftruncate64(file, 5)); }));
    EXPECT_EQ("RTC005 stat64 1", counted([&] { EXPECT_EQ(0, stat64(path.c_str(), &status)); }));
    EXPECT_EQ(5, status.st_size);
    EXPECT_EQ("RTC005 lstat64 1", counted([&] { EXPECT_EQ(0, lstat64(path.c_str(), &status)); }));
    char bytes[8] = "";
    iovec part = {bytes, 4};
    EXPECT_EQ("RTC005 preadv 1", counted([&] { EXPECT_EQ(4, preadv(file, &part, 1, 0)); }));
    EXPECT_EQ("RTC005 posix_fallocate 1", counted([] { EXPECT_EQ(0, posix_fallocate(file, 0, 100)); }));
    struct flock whole {};
    whole.l_type = F_WRLCK;
    EXPECT_EQ("RTC005 fcntl 1", counted([&] { EXPECT_EQ(0, fcntl(file, F_SETLKW, &whole)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(0, fcntl(file, F_SETLK, &whole)); }));
    EXPECT_EQ("RTC005 lockf 1", counted([] { EXPECT_EQ(0, lockf(file, F_LOCK, 0)); }));
    EXPECT_EQ("", counted([] { EXPECT_EQ(0, lockf(file, F_TLOCK, 0)); }));
    EXPECT_EQ("RTC005 syscall 1", counted([] { EXPECT_EQ(2, syscall(SYS_write, file, "xy", 2)); }));
    close(file);
    EXPECT_EQ("RTC005 remove 1", counted([&] { EXPECT_EQ(0, remove(path.c_str())); }));
    // What the C++ library does.
    EXPECT_THAT(counted([&] { EXPECT_FALSE(std::filesystem::exists(path)); }), testing::HasSubstr("RTC005 stat"));
}

TEST(SystemCalls, OnPipesAndSocketsAreCountedIfTheyMayBlock) {
    int pair[2], quiet[2];
    ASSERT_EQ(0, socketpair(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0, pair));
    ASSERT_EQ(0, pipe2(quiet, O_NONBLOCK | O_CLOEXEC));
    char byte = 'x';
    EXPECT_EQ("RTC005 send 1", counted([&] { EXPECT_EQ(1, send(pair[0], &byte, 1, 0)); }));
    EXPECT_EQ("RTC005 recv 1", counted([&] { EXPECT_EQ(1, recv(pair[1], &byte, 1, 0)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(1, send(pair[0], &byte, 1, MSG_DONTWAIT)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(1, recv(pair[1], &byte, 1, MSG_DONTWAIT)); }));
    EXPECT_EQ("RTC005 sendto 1", counted([&] { EXPECT_EQ(1, sendto(pair[0], &byte, 1, 0, nullptr, 0)); }));
    EXPECT_EQ("RTC005 recvfrom 1", counted([&] { EXPECT_EQ(1, recvfrom(pair[1], &byte, 1, 0, nullptr, nullptr)); }));
    iovec part = {&byte, 1};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    EXPECT_EQ("RTC005 sendmsg 1", counted([&] { EXPECT_EQ(1, sendmsg(pair[0], &message, 0)); }));
    EXPECT_EQ("RTC005 recvmsg 1", counted([&] { EXPECT_EQ(1, recvmsg(pair[1], &message, 0)); }));
    int waiting = -1;
    EXPECT_EQ("RTC005 ioctl 1", counted([&] { EXPECT_EQ(0, ioctl(pair[0], FIONREAD, &waiting)); }));
    EXPECT_EQ(0, waiting);
    EXPECT_EQ("", counted([&] { EXPECT_EQ(0, ioctl(quiet[0], FIONREAD, &waiting)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(1, write(quiet[1], &byte, 1)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(1, read(quiet[0], &byte, 1)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(1, syscall(SYS_write, quiet[1], &byte, 1)); }));
    EXPECT_EQ("", counted([] { EXPECT_EQ(-1, write(-1, "x", 1)); }));  // fails at once
    EXPECT_EQ(EBADF, errno);
    for (const int fd : {pair[0], pair[1], quiet[0], quiet[1]}) close(fd);
}

TEST(SystemCalls, ThatStartProgramsAreCounted) {
    int status = -1;
    EXPECT_EQ("RTC005 fork 1, RTC005 waitpid 1", counted([&] {
                  const pid_t child = fork();
                  if (child == 0) _exit(7);
                  EXPECT_EQ(child, waitpid(child, &status, 0));
              }));
    EXPECT_EQ(7, WEXITSTATUS(status));
    EXPECT_EQ("RTC005 system 1", counted([] { EXPECT_EQ(0, system("true")); }));
    EXPECT_EQ("RTC005 posix_spawn 1", counted([&] {
                  char name[] = "true";
                  char* words[] = {name, nullptr};
                  pid_t child = 0;
                  EXPECT_EQ(0, posix_spawn(&child, "/bin/true", nullptr, nullptr, words, environ));
                  while (waitpid(child, &status, WNOHANG) == 0) sched_yield();
              }));
    EXPECT_EQ(0, status);
}

TEST(SystemCalls, ThatLookSomethingUpAreCounted) {
    EXPECT_EQ("RTC005 gethostbyname 1", counted([] { EXPECT_NE(nullptr, gethostbyname("127.0.0.1")); }));
    EXPECT_EQ("RTC005 getaddrinfo 1", counted([] {
                  addrinfo *found = nullptr, numeric{};
                  numeric.ai_flags = AI_NUMERICHOST;
                  EXPECT_EQ(0, getaddrinfo("127.0.0.1", nullptr, &numeric, &found));
                  block = found;
              }));
    freeaddrinfo(static_cast<addrinfo*>(block));
    EXPECT_EQ("RTC005 getpwuid 1", counted([] { (void)getpwuid(0); }));
    char path[PATH_MAX];
    EXPECT_EQ("RTC005 realpath 1", counted([&] { EXPECT_STREQ("/", realpath("/tmp/..", path)); }));
    struct statvfs system {};
    EXPECT_EQ("RTC005 statvfs 1", counted([&] { EXPECT_EQ(0, statvfs("/", &system)); }));
    EXPECT_LT(0u, system.f_bsize);
}

/** By the name alone: only the library that asks knows the folder. */
TEST(SystemCalls, ThatLoadALibraryAreCountedAndFindIt) {
    void* const opener = dlopen(OPENER_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(nullptr, opener) << dlerror();
    const auto openOther = reinterpret_cast<void* (*)()>(dlsym(opener, "openOtherLibrary"));
    void* other = openOther();
    ASSERT_NE(nullptr, other) << dlerror();
    EXPECT_THAT(counted([&] { EXPECT_EQ(other, openOther()); }), testing::HasSubstr("RTC005 dlopen 1"));
    for (int i = 0; i != 2; ++i) EXPECT_EQ(0, dlclose(other));
    EXPECT_EQ(0, dlclose(opener));
}

TEST(Streams, AreCountedOnceWhateverTheyDo) {
    static std::FILE* stream = nullptr;
    EXPECT_EQ("RTC006 fopen 1", counted([] { stream = std::fopen("/dev/null", "r+"); }));
    EXPECT_EQ("RTC006 fprintf 1", counted([] { EXPECT_EQ(5, std::fprintf(stream, "%d %s\n", 42, "x")); }));
    EXPECT_EQ("RTC006 fputs 1", counted([] { std::fputs("text", stream); }));
    EXPECT_EQ("RTC006 fputc 1", counted([] { std::fputc('x', stream); }));
    EXPECT_EQ("RTC006 fwrite 1", counted([] { EXPECT_EQ(3u, std::fwrite("abc", 1, 3, stream)); }));
    EXPECT_EQ("RTC006 fflush 1", counted([] { EXPECT_EQ(0, std::fflush(stream)); }));
    char text[10];
    EXPECT_EQ("RTC006 fgets 1", counted([&] { EXPECT_EQ(nullptr, std::fgets(text, 10, stream)); }));
    int number = 0;
    EXPECT_EQ("RTC006 fscanf 1", counted([&] { EXPECT_EQ(EOF, std::fscanf(stream, "%d", &number)); }));
    EXPECT_EQ("RTC006 rewind 1", counted([] { std::rewind(stream); }));
    EXPECT_EQ("RTC003 flockfile 1", counted([] { flockfile(stream), funlockfile(stream); }));
    EXPECT_EQ("RTC006 fclose 1", counted([] { EXPECT_EQ(0, std::fclose(stream)); }));
    EXPECT_EQ("RTC006 printf 1", counted([] { EXPECT_EQ(4, std::printf("%s\n", "xyz")); }));
    EXPECT_EQ("RTC006 puts 1", counted([] { std::puts("puts"); }));
    EXPECT_EQ("RTC006 dprintf 1", counted([] { EXPECT_EQ(3, dprintf(1, "%d\n", 42)); }));
    EXPECT_EQ("", counted([&] { EXPECT_EQ(2, std::snprintf(text, 10, "%d", 42)); }));
    stream = std::fopen("/dev/null", "r+");
    EXPECT_EQ("RTC006 fwprintf 1", counted([] { EXPECT_EQ(3, std::fwprintf(stream, L"%d\n", 42)); }));
    EXPECT_EQ("RTC006 fputws 1", counted([] { std::fputws(L"text", stream); }));
    std::fclose(stream);
}

extern "C" {
int __printf_chk(int, const char*, ...);
ssize_t __read_chk(int, void*, size_t, size_t);
int __open_2(const char*, int);
}

TEST(Fortified, FunctionsAreCountedToo) {
    static int file = -1;
    char byte = 0;
    EXPECT_EQ("RTC005 open 1", counted([] { file = __open_2("/dev/zero", O_RDONLY | O_CLOEXEC); }));
    EXPECT_EQ("RTC005 read 1", counted([&] { EXPECT_EQ(1, __read_chk(file, &byte, 1, 1)); }));
    EXPECT_EQ("RTC006 printf 1", counted([] { EXPECT_EQ(3, __printf_chk(1, "%d\n", 42)); }));
    close(file);
}

}  // namespace
