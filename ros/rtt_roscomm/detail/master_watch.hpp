// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_MASTER_WATCH_HPP
#define RTT_ROSCOMM_DETAIL_MASTER_WATCH_HPP

#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace rtt_roscomm::detail {

/** Asks the master once a second whether it knows this node. A master that was started again does not, and roscpp does not
    tell it: this registers all topics and services of the node there. */
class MasterWatch {
public:
    /** Never destroyed: components of static objects end later than all others. */
    static MasterWatch& instance();

    /** They keep the watch running. */
    void addUser();
    void removeUser();
    /** A service that this node offers, by its resolved name. Roscpp has no list of them. */
    void addService(const std::string& name);
    void removeService(const std::string& name);
    /** Executes it as soon as the master answers. */
    void keep(std::function<void()> work);
    /** Ends the thread, and waits for it, for 2 s at most. */
    void stop();

private:
    enum class Master { Away, KnowsUs, New };
    MasterWatch() = default;
    void run();
    void look();
    void tellIfNodeIsLost();
    Master ask() const;
    bool registerAll();
    bool isWatching();
    void workKept();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::set<std::string> services_;
    std::vector<std::function<void()>> kept_;
    unsigned users_ = 0;
    bool isRunning_ = false, isStopped_ = false;
    bool isAway_ = false, isForgotten_ = false, isLost_ = false;  // of the watch's thread
};

}  // namespace rtt_roscomm::detail

#endif
