// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The node of this process: begun when rtt_rosnode is imported and the master answers, ended with the runtime.
#include <rtt_ros/node.hpp>

#include <rtt/Logger.hpp>
#include <rtt/os/startstop.h>
#include <rtt_ros/detail/master.hpp>

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/param.h>
#include <ros/spinner.h>
#include <ros/this_node.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace ros {
namespace master {
void init(const M_string& remappings);  // of libroscpp; no header has it
}
}  // namespace ros

namespace rtt_ros {
namespace {

using Clock = std::chrono::steady_clock;
using RTT::endlog;
using RTT::log;

constexpr std::chrono::milliseconds kMasterAnswers{800};
constexpr std::chrono::seconds kBetweenLooks{1};
/** Calls of roscpp wait for a master that is lost; without an end by default. */
constexpr double kRetrySeconds = 2.0;
constexpr int kMostThreads = 256;
constexpr std::chrono::seconds kCallbacksEnd{3};

struct Node {
    std::mutex mutex;
    bool spins = false;  // rtt_rosnode is imported
    bool ended = false;
    std::string silence;  // why the master did not answer
    Clock::time_point looked;
    std::unique_ptr<ros::AsyncSpinner> spinner;
};

/** Never destroyed: threads of other libraries may ask when the program ends. */
Node& node() {
    static Node* const only = new Node;
    return *only;
}

bool isUp() { return ros::isInitialized() && ros::isStarted() && ros::ok() && !ros::isShuttingDown(); }

/** The arguments of __os_init(): a copy, because ros::init() removes from the list what is its own. */
class Words {
public:
    Words() : words_(__os_main_argv(), __os_main_argv() + __os_main_argc()) {
        if (words_.empty()) words_.push_back("rtt");
        for (std::string& word : words_) pointers_.push_back(word.data());
        pointers_.push_back(nullptr);
    }
    Words(const Words&) = delete;
    Words& operator=(const Words&) = delete;

    int count() const { return static_cast<int>(words_.size()); }
    char** pointers() { return pointers_.data(); }

private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

struct Master {
    std::string uri, host;
    std::uint32_t port = 0;
};

/** The master that the arguments or the environment name. False, logged, if the text is no URI. */
bool findMaster(Words& words, Master& master) {
    master.uri = ros::getROSArg(words.count(), words.pointers(), "__master");
    const char* const variable = std::getenv("ROS_MASTER_URI");
    if (master.uri.empty() && variable) master.uri = variable;
    if (master.uri.empty()) {
        // As the tools of ROS do; roscpp would end the process.
        master.uri = "http://localhost:11311";
        log(RTT::Info) << "ROS_MASTER_URI is not set: taking " << master.uri << endlog();
        setenv("ROS_MASTER_URI", master.uri.c_str(), 1);
    }
    if (ros::network::splitURI(master.uri, master.host, master.port)) return true;
    log(RTT::Error) << "'" << master.uri << "' is no URI of a ROS master; set ROS_MASTER_URI to one such as "
                    << "http://localhost:11311" << endlog();
    return false;
}

/** roscpp's own remarks would be mixed with the log on the screen. What packages say by ROS_INFO and so on stays. */
void quietRoscpp() {
    if (std::getenv("ROSCONSOLE_CONFIG_FILE")) return;
    if (ros::console::set_logger_level("ros.roscpp", ros::console::levels::Error))
        ros::console::notifyLoggerLevelsChanged();
}

void startSpinner(Node& self) {
    if (self.spinner) return;
    int threads = 0;
    ros::param::param("~spinner_threads", threads, 0);
    if (threads < 0 || threads > kMostThreads) {
        log(RTT::Warning) << "parameter ~spinner_threads is " << threads << ", expected 0 (one for each processor) to "
                          << kMostThreads << "; taking 0" << endlog();
        threads = 0;
    }
    auto spinner = std::make_unique<ros::AsyncSpinner>(static_cast<std::uint32_t>(threads));
    spinner->start();
    self.spinner = std::move(spinner);
}

/** Starts the node, and its spinner, if the master answers. False with the reason, or, logged and without one, if it can
    never be. Called with the lock held. */
bool start(Node& self, std::string& why) {
    Words words;
    Master master;
    why.clear();
    try {
        if (!isUp()) {
            if (!findMaster(words, master)) return false;
            self.looked = Clock::now();
            // Only then, because ros::init() sets parameters, ros::start() registers, and both wait for the master.
            const std::string silence = detail::whyMasterIsSilent(master.host, master.port, kMasterAnswers);
            if (!silence.empty()) {
                why = "the ROS master at " + master.uri + " does not answer: " + silence +
                      "; start it (roscore), or set ROS_MASTER_URI before the program starts";
                return false;
            }
            ros::master::setRetryTimeout(ros::WallDuration(kRetrySeconds));
            quietRoscpp();
            int count = words.count();
            ros::init(count, words.pointers(), "rtt",
                      ros::init_options::NoSigintHandler | ros::init_options::AnonymousName);
            ros::start();
        }
        startSpinner(self);
    } catch (const std::exception& thrown) {
        log(RTT::Error) << "this process cannot be a ROS node: " << thrown.what() << endlog();
        return false;
    }
    return true;
}

/** False if a callback does not end in time. */
bool endsSoon(std::unique_ptr<ros::AsyncSpinner> spinner) {
    const std::shared_ptr<ros::AsyncSpinner> kept = std::move(spinner);
    const auto ended = std::make_shared<std::promise<void>>();
    std::future<void> end = ended->get_future();
    std::thread([kept, ended] {
        kept->stop();
        ended->set_value();
    }).detach();
    return end.wait_for(kCallbacksEnd) == std::future_status::ready;
}

}  // namespace

bool isNode(std::string& why) {
    Node& self = node();
    why.clear();
    if (isUp()) return true;
    const std::lock_guard<std::mutex> lock(self.mutex);
    if (self.ended || ros::isShuttingDown()) {
        why = "the ROS node of this process has been shut down";
    } else if (!self.spins) {
        why = "this process is no ROS node: import rtt_rosnode first";
    } else if (Clock::now() - self.looked < kBetweenLooks) {
        why = self.silence;
    } else {
        (void)start(self, self.silence);
        why = self.silence;
    }
    return why.empty() && isUp();
}

bool isNodeReady(std::string& why) {
    if (!isNode(why)) return false;
    const std::string silence =
        detail::whyMasterIsSilent(ros::master::getHost(), ros::master::getPort(), kMasterAnswers);
    if (!silence.empty()) why = "the ROS master at " + ros::master::getURI() + " does not answer: " + silence;
    return silence.empty();
}

bool isNodeLost() {
    Node& self = node();
    const std::lock_guard<std::mutex> lock(self.mutex);
    return !self.ended && ros::isInitialized() && ros::isShuttingDown();
}

bool startNode() {
    Node& self = node();
    const std::lock_guard<std::mutex> lock(self.mutex);
    const RTT::Logger::In in("rosnode");
    if (self.ended) {
        log(RTT::Error) << "the ROS node of this process has been shut down, and cannot be started again" << endlog();
        return false;
    }
    if (start(self, self.silence))
        log(RTT::Info) << "this process is the ROS node " << ros::this_node::getName() << " at "
                       << ros::master::getURI() << endlog();
    else if (self.silence.empty())
        return false;
    else
        log(RTT::Warning) << self.silence << "; then import rtt_rosnode again, or use a topic" << endlog();
    self.spins = true;
    return true;
}

void stopNode() {
    Node& self = node();
    std::unique_ptr<ros::AsyncSpinner> spinner;
    {
        const std::lock_guard<std::mutex> lock(self.mutex);
        if (!self.spins || self.ended) return;
        self.ended = true;
        spinner = std::move(self.spinner);
    }
    // Without the lock, because a callback may ask whether the node is ready.
    if (spinner && !endsSoon(std::move(spinner)))
        log(RTT::Error) << "a callback of the ROS node does not end, such as a service whose operation no component "
                        << "executes; it is not waited for" << endlog();
    if (!ros::isInitialized()) return;
    // Or roscpp waits without end to take back all topics from a master that is stopped.
    const std::string silence =
        detail::whyMasterIsSilent(ros::master::getHost(), ros::master::getPort(), kMasterAnswers);
    if (!silence.empty()) ros::master::init({{"__master", "http://127.0.0.1:1/"}});
    ros::shutdown();
}

}  // namespace rtt_ros
