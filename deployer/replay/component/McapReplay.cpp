// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/McapReplay.hpp>

#include "../player/recording_player.hpp"
#include "replay_clock.hpp"
#include "replay_options.hpp"
#include "replay_ports.hpp"

#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/Timer.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/threads.hpp>

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace OCL {
namespace {

using replay::RecordingPlayer;
using RTT::log;
using RTT::nsecs;

/** The longest time that samples are written without a pause, so that stop() and operations need not wait long. */
constexpr nsecs kLongestCycle = 50000000;
/** A recording with one time only begins again so much later. */
constexpr nsecs kShortestLoop = 10000000;

nsecs realNow() { return RTT::os::TimeService::ticks2nsecs(rtos_get_time_ns()); }

/** Wakes a component that has no period. */
class Alarm : public RTT::os::Timer {
public:
    Alarm(RTT::TaskContext& component, int scheduler, int priority)
        : RTT::os::Timer(1, scheduler, priority, component.getName() + ".Alarm"), component_(component) {}
    ~Alarm() override { stopThread(); }
    void timeout(TimerId) override { (void)component_.trigger(); }

private:
    RTT::TaskContext& component_;
};

}  // namespace

struct McapReplay::Impl {
    explicit Impl(McapReplay& component) : self(component), ports(component) {}

    bool open();
    void close();
    bool addPort(const replay::Topic& topic);
    void logProblems();
    nsecs recordedAt(double seconds) const { return player->begin() + static_cast<nsecs>(seconds * 1e9); }
    double secondsAt(nsecs recorded) const { return static_cast<double>(recorded - player->begin()) / 1e9; }
    void goTo(nsecs recorded);
    void begin(nsecs recorded);
    bool deliverDue();
    bool beginAgain();
    void deliver(nsecs due);
    void wakeIn(double seconds);
    nsecs now() const { return RTT::os::TimeService::Instance()->getNSecs(); }

    McapReplay& self;
    replay::ReplayOptions options;
    // Attributes.
    double time = 0, duration = 0;
    unsigned int samples = 0, leftOut = 0, rounds = 0;

    std::mutex mutex;  // guards what follows; held while samples are written
    std::unique_ptr<RecordingPlayer> player;
    replay::ReplayPorts ports;  // removed before the player
    replay::ReplayClock clock;
    std::optional<nsecs> nextStart;  // of seek(), while the component does not run
    bool runs = false, steps = false, toldSpeed = false;
    nsecs first = 0;  // the time at which this round began
    std::size_t logged = 0;
    std::uint64_t writtenBefore = 0, leftOutBefore = 0;
    bool any = false;  // samples in this round

    // Null with a period. Its thread may execute the component, so it is destroyed without the mutex.
    std::unique_ptr<Alarm> alarm;
};

McapReplay::McapReplay(const std::string& name)
    : RTT::TaskContext(name, RTT::base::TaskCore::PreOperational), impl_(new Impl(*this)) {
    replay::ReplayOptions& options = impl_->options;
    addProperty("ReplayFile", options.file).doc("The recording, an MCAP file.");
    addProperty("Speed", options.speed)
        .doc("How fast it is replayed: 1 as recorded, 2 twice as fast, 0 as fast as possible.");
    addProperty("Loop", options.loop).doc("Begin again at the end.");
    addProperty("Start", options.start).doc("Leave out what is before this time of the recording. [s]");
    addProperty("End", options.end).doc("Leave out what is at this time of the recording and later. 0: nothing. [s]");
    addProperty("Tolerate", options.tolerate)
        .doc(
            "Replay types that have other fields than the recorded ones: fields that are not recorded keep their "
            "defaults.");
    addProperty("Topics", options.topics)
        .doc("The ports to replay: topics or patterns such as '/Camera/*', with blanks between them. Empty: all.");
    addAttribute("Time", impl_->time);
    addAttribute("Duration", impl_->duration);
    addAttribute("Samples", impl_->samples);
    addAttribute("LeftOut", impl_->leftOut);
    addAttribute("Rounds", impl_->rounds);
    addOperation("seek", &McapReplay::seek, this)
        .doc("Goes on at a time of the recording, or starts there.")
        .arg("seconds", "from its begin");
    addOperation("pause", &McapReplay::pause, this).doc("Stands still until resume().");
    addOperation("resume", &McapReplay::resume, this).doc("Goes on after pause().");
    addOperation("step", &McapReplay::step, this).doc("After pause(): writes the samples of the next recorded time.");
}

McapReplay::~McapReplay() {
    stopForGood();
    impl_->alarm.reset();
    impl_->close();
}

bool McapReplay::configureHook() {
    impl_->alarm.reset();
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->close();
    if (impl_->open()) return true;
    impl_->close();
    return false;
}

void McapReplay::cleanupHook() {
    impl_->alarm.reset();
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->close();
}

bool McapReplay::Impl::open() {
    std::string why;
    try {
        player = RecordingPlayer::open(options.file, {options.tolerate}, why);
    } catch (const std::exception& thrown) {
        why = options.file + ": error: [MCP010] the recording cannot be read: " + thrown.what();
    }
    std::vector<replay::Topic> topics;
    if (player) {
        duration = secondsAt(player->end());
        why = whatIsWrong(options, duration);
        if (why.empty()) topics = chooseTopics(player->topics(), options.topics, why);
        if (!why.empty()) why = options.file + ": " + why;
    }
    if (!why.empty()) {
        log(RTT::Error) << "'" << self.getName() << "' is not configured: " << why << RTT::endlog();
        return false;
    }
    bool good = true;
    for (const replay::Topic& topic : topics) good = addPort(topic) && good;
    logProblems();
    return good;
}

bool McapReplay::Impl::addPort(const replay::Topic& topic) {
    std::string problem;
    RTT::base::OutputPortInterface* const port = player->port(topic.topic, problem);
    std::string why;
    if (port && !ports.add(topic, *port, why)) problem = options.file + ": " + why;
    if (!problem.empty()) log(port && why.empty() ? RTT::Warning : RTT::Error) << problem << RTT::endlog();
    return port && why.empty();
}

void McapReplay::Impl::close() {
    ports.remove();
    player.reset();
    nextStart.reset();
    logged = 0;
    duration = 0;
}

void McapReplay::Impl::logProblems() {
    if (player->problemCount() == logged) return;
    const std::vector<std::string> all = player->problems();
    for (; logged != player->problemCount(); ++logged) log(RTT::Warning) << all[logged] << RTT::endlog();
}

bool McapReplay::startHook() {
    Impl& its = *impl_;
    its.alarm.reset();
    RTT::base::ActivityInterface* const activity = getActivity();
    if (activity && !activity->isPeriodic()) {
        RTT::os::ThreadInterface* const thread = activity->thread();
        its.alarm.reset(
            new Alarm(*this, thread ? thread->getScheduler() : ORO_SCHED_OTHER, thread ? thread->getPriority() : 0));
    }
    const std::lock_guard<std::mutex> lock(its.mutex);
    const std::string wrong = whatIsWrong(its.options, its.duration);
    if (!wrong.empty()) {
        log(RTT::Error) << "'" << getName() << "' does not start: " << wrong << RTT::endlog();
        return false;
    }
    its.writtenBefore = its.player->written();
    its.leftOutBefore = its.player->leftOut();
    its.samples = its.leftOut = its.rounds = 0;
    its.steps = its.toldSpeed = false;
    its.runs = true;
    its.begin(its.nextStart.value_or(its.recordedAt(its.options.start)));
    its.nextStart.reset();
    return true;
}

/** The next sample is the first one at or after that time. */
void McapReplay::Impl::goTo(nsecs recorded) {
    player->seek(recorded, options.end > 0 ? recordedAt(options.end) : std::numeric_limits<nsecs>::max());
    first = recorded;
    any = false;
    time = secondsAt(recorded);
}

void McapReplay::Impl::begin(nsecs recorded) {
    goTo(recorded);
    clock.begin(recorded, now(), options.speed);
}

void McapReplay::updateHook() {
    bool ends = false;
    try {
        const std::lock_guard<std::mutex> lock(impl_->mutex);
        ends = !impl_->deliverDue();
        impl_->logProblems();
    } catch (const std::exception& thrown) {
        log(RTT::Error) << "'" << getName() << "' cannot go on: " << impl_->options.file << ": " << thrown.what()
                        << RTT::endlog();
        ends = true;
    }
    if (ends) (void)stop();
}

/** False at the end. */
bool McapReplay::Impl::deliverDue() {
    if (replay::isSpeed(options.speed)) {
        clock.setSpeed(now(), options.speed);
    } else if (!std::exchange(toldSpeed, true)) {
        log(RTT::Error) << "'" << self.getName() << "' keeps its speed: " << whatIsWrong(options, duration)
                        << RTT::endlog();
    }
    for (const nsecs begin = realNow();;) {
        const std::optional<nsecs> due = player->next();
        if (!due) {
            if (!beginAgain()) return false;
            continue;
        }
        if (std::exchange(steps, false)) {
            deliver(*due);
            clock.moveTo(*due, now());
            continue;
        }
        if (clock.stands()) return true;
        if (!clock.isDue(*due, now())) {
            wakeIn(clock.wait(*due, now()));
            return true;
        }
        deliver(*due);
        if (realNow() - begin > kLongestCycle) {
            wakeIn(0);
            return true;
        }
    }
}

void McapReplay::Impl::deliver(nsecs due) {
    player->deliver();
    any = true;
    time = secondsAt(due);
    samples = static_cast<unsigned int>(player->written() - writtenBefore);
    leftOut = static_cast<unsigned int>(player->leftOut() - leftOutBefore);
}

bool McapReplay::Impl::beginAgain() {
    if (!options.loop || !any) return false;
    ++rounds;
    const bool stands = clock.stands();
    const nsecs recorded = recordedAt(options.start);
    const bool isShort = recordedAt(time) <= first;
    goTo(recorded);
    clock.begin(isShort ? recorded - kShortestLoop : recorded, now(), options.speed);
    if (stands) clock.stop(now());
    return true;
}

void McapReplay::Impl::wakeIn(double seconds) {
    constexpr double kLongestWait = 3600;  // then it waits again
    if (!alarm) return;
    if (seconds <= 0)
        (void)self.trigger();
    else
        (void)alarm->arm(0, std::min(seconds, kLongestWait));
}

void McapReplay::stopHook() {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->runs = false;
    if (impl_->alarm) (void)impl_->alarm->killTimer(0);
    impl_->logProblems();
}

// --- operations ----------------------------------------------------------------------------------------------------

bool McapReplay::seek(double seconds) {
    {
        const std::lock_guard<std::mutex> lock(impl_->mutex);
        Impl& its = *impl_;
        const double end = its.options.end > 0 ? std::min(its.options.end, its.duration) : its.duration;
        if (!its.player || !(seconds >= its.options.start && seconds <= end)) return false;
        const nsecs recorded = its.recordedAt(seconds);
        if (!its.runs) {
            its.nextStart = recorded;
            return true;
        }
        its.goTo(recorded);
        its.clock.moveTo(recorded, its.now());
    }
    (void)trigger();
    return true;
}

bool McapReplay::pause() {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    if (!impl_->runs) return false;
    impl_->clock.stop(impl_->now());
    return true;
}

bool McapReplay::resume() {
    {
        const std::lock_guard<std::mutex> lock(impl_->mutex);
        if (!impl_->runs || !impl_->clock.stands()) return false;
        impl_->clock.goOn(impl_->now());
    }
    (void)trigger();
    return true;
}

bool McapReplay::step() {
    {
        const std::lock_guard<std::mutex> lock(impl_->mutex);
        if (!impl_->runs || !impl_->clock.stands()) return false;
        impl_->steps = true;
    }
    (void)trigger();
    return true;
}

}  // namespace OCL
