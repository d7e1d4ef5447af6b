// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_DOOR_HPP
#define OROFORGE_LIVE_DOOR_HPP

#include "socket_folder.hpp"

#include <functional>
#include <string>

#include <pthread.h>
#include <sys/types.h>

namespace OCL::live {

/** A socket in a folder, on which clients connect. Its file is removed in the end. */
class DoorSocket {
public:
    /** Converts to false, with the reason, if there can be none. The folder must outlive it. */
    DoorSocket(const SocketFolder& folder, const std::string& name, std::string& error);
    ~DoorSocket();
    DoorSocket(const DoorSocket&) = delete;
    DoorSocket& operator=(const DoorSocket&) = delete;
    explicit operator bool() const { return bool(socket_); }
    int get() const { return socket_.get(); }

private:
    const SocketFolder& folder_;
    const std::string name_;
    Descriptor socket_;
    ino_t file_ = 0;
};

/**
 * Waits at a socket for the first client that may enter, in a thread that sleeps until then.
 *
 * `enter` is called in that thread, once, with the connected client; what it throws ends the program. The thread ends
 * afterwards: later clients are up to that function. All memory of the thread is its stack of 256 KiB, of which 8 KiB
 * are used until a client comes.
 */
class Door {
public:
    typedef std::function<void(Descriptor client)> Enter;
    /** Converts to false if there is no thread or file for it. */
    Door(int listener, Enter enter);
    /** Wakes the thread and waits for its end. */
    ~Door();
    Door(const Door&) = delete;
    Door& operator=(const Door&) = delete;
    explicit operator bool() const { return started_; }

private:
    void wait();
    Descriptor acceptClient(bool& exhausted) const;

    const int listener_;
    const Enter enter_;
    Descriptor ending_;
    pthread_t thread_{};
    bool started_ = false;
};

}  // namespace OCL::live

#endif
