// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_SOCKET_FOLDER_HPP
#define OROFORGE_LIVE_SOCKET_FOLDER_HPP

#include <rtt/os/descriptor.hpp>

#include <string>

namespace OCL::live {

using RTT::os::detail::Descriptor;

/** The folder with the sockets of the deployments of this user. */
class SocketFolder {
public:
    /** Why the folder cannot be used. */
    struct Fault {
        std::string text;
        bool isForeign = false;  ///< somebody else may have put it there
    };

    /** "$XDG_RUNTIME_DIR/oroforge", or "/tmp/oroforge-1000" if the variable is empty or not set. */
    static std::string usual();

    /** Makes the folder if it is not there. It must be a folder of this user, and gets the mode 0700. */
    SocketFolder(std::string path, Fault& fault);
    explicit operator bool() const { return bool(folder_); }

    const std::string& path() const { return path_; }
    /** The open folder. */
    int get() const { return folder_.get(); }
    /** Removes the sockets of processes that have ended. Never blocks on a process that lives. */
    void removeStale() const;

private:
    std::string path_;
    Descriptor folder_;
};

}  // namespace OCL::live

#endif
