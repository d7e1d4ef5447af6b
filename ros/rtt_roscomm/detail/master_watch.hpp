// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_MASTER_WATCH_HPP
#define RTT_ROSCOMM_DETAIL_MASTER_WATCH_HPP

#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <thread>

namespace rtt_roscomm::detail {

/** Asks the master once a second who it is. A master that was started again knows nothing of this node, and roscpp does
    not tell it: this registers all topics and services of the node there. */
class MasterWatch {
public:
    static MasterWatch& instance();
    ~MasterWatch();

    /** They keep the watch running. */
    void addUser();
    void removeUser();
    /** A service that this node offers, by its resolved name. Roscpp has no list of them. */
    void addService(const std::string& name);
    void removeService(const std::string& name);

private:
    MasterWatch() = default;
    void run();
    void look();
    void registerAll();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::set<std::string> services_;
    unsigned users_ = 0;
    bool isRunning_ = false;
    std::thread thread_;
    int master_ = 0;  // its process, of the watch's thread
    bool isAway_ = false;
};

}  // namespace rtt_roscomm::detail

#endif
