// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "door.hpp"

#include "peer.hpp"
#include "unix_address.hpp"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>

namespace OCL::live {
namespace {

constexpr std::size_t kStack = 256 * 1024;
/** When the process has no more files, a client waits that long for the next attempt, in ms. */
constexpr int kPause = 100;

bool isExhaustion(int error) { return error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM; }

}  // namespace

DoorSocket::DoorSocket(const SocketFolder& folder, const std::string& name, std::string& error)
    : folder_(folder), name_(name) {
    Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const UnixAddress address(folder, name);
    // The file gets the mode of the socket, so that no moment is left in which others may connect.
    bool good = socket && address && ::fchmod(socket.get(), 0600) == 0 &&
                ::bind(socket.get(), address.get(), address.size()) == 0;
    struct stat file {};
    good = good && ::fstatat(folder.get(), name.c_str(), &file, AT_SYMLINK_NOFOLLOW) == 0;
    if (good) file_ = file.st_ino;
    good = good && ::listen(socket.get(), SOMAXCONN) == 0;
    if (good)
        socket_ = std::move(socket);
    else
        error = address ? std::strerror(errno) : "the name is too long";
}

DoorSocket::~DoorSocket() {
    struct stat file {};
    if (file_ == 0 || ::fstatat(folder_.get(), name_.c_str(), &file, AT_SYMLINK_NOFOLLOW) != 0) return;
    if (file.st_ino == file_) (void)::unlinkat(folder_.get(), name_.c_str(), 0);
}

Door::Door(int listener, Enter enter)
    : listener_(listener), enter_(std::move(enter)), ending_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (!ending_) return;
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStack);
    // The program may have started with a real-time scheduler.
    pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const auto run = [](void* self) -> void* {
        (void)::pthread_setname_np(::pthread_self(), "live door");
        static_cast<Door*>(self)->wait();
        return nullptr;
    };
    started_ = pthread_create(&thread_, &attributes, run, this) == 0;
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    pthread_attr_destroy(&attributes);
}

Door::~Door() {
    if (!started_) return;
    const std::uint64_t one = 1;
    (void)!::write(ending_.get(), &one, sizeof one);
    (void)::pthread_join(thread_, nullptr);
}

void Door::wait() {
    bool exhausted = false;
    for (;;) {
        pollfd polled[] = {{ending_.get(), POLLIN, 0}, {listener_, POLLIN, 0}};
        const int count = ::poll(polled, exhausted ? 1 : 2, exhausted ? kPause : -1);
        if (polled[0].revents != 0) return;
        if (count < 0 && errno != EINTR) return;
        if (!exhausted && count > 0) {
            Descriptor client = acceptClient(exhausted);
            if (client) return enter_(std::move(client));
        } else {
            exhausted = false;
        }
    }
}

Descriptor Door::acceptClient(bool& exhausted) const {
    Descriptor client(::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    exhausted = !client && isExhaustion(errno);
    if (client && !peerOf(client.get()).mayEnter()) client.reset();
    return client;
}

}  // namespace OCL::live
