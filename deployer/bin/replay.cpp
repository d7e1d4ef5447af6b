// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replay.hpp"

#include "../deployment/replaced.hpp"
#include "../deployment/report.hpp"
#include "../schedule/schedule.hpp"
#include "../schedule/stand_ins.hpp"
#include "program_report.hpp"
#include "replay_record.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/located_log.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/plugin/shared_library.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace OCL::deploy {
namespace {

namespace diag = oroforge::diag;

std::unique_ptr<replay::Player> openRecording(const std::string& file, bool tolerate, std::string& error) {
    using RTT::plugin::SharedLibrary;
    // Beside the component library.
    const std::string runtime =
        SharedLibrary::fileWith(reinterpret_cast<const void*>(&RTT::internal::logLocated));  // any function of it
    const std::string name = runtime.substr(0, runtime.rfind('/') + 1) +
                             "orocos/" OROCOS_TARGET_NAME "/ocl/liborocos-ocl-replay-" OROCOS_TARGET_NAME ".so";
    std::error_code none;
    if (!std::filesystem::exists(name, none)) {
        error = "--replay: error: [" + std::string("RPL001") + "] this toolchain has no part that reads recordings, " +
                name + "; it is made if libzstd-dev or liblz4-dev is installed when the toolchain is built";
        return nullptr;
    }
    SharedLibrary module(name, SharedLibrary::Global, error);
    auto* const open = module ? module.function<decltype(oroOpenRecording)>("oroOpenRecording") : nullptr;
    if (!open) {
        error = "--replay: error: [" + std::string("RPL001") + "] the part that reads recordings cannot be used: " +
                (module ? name + " is of another version" : error);
        return nullptr;
    }
    module.keep();
    replay::PlayerOptions options;
    options.tolerate = tolerate;
    return std::unique_ptr<replay::Player>(open(file.c_str(), options, error));
}

/** Keeps recorders from writing over the file. */
class ReadLock {
public:
    explicit ReadLock(const std::string& file) : file_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (file_ >= 0) (void)::flock(file_, LOCK_SH | LOCK_NB);
    }
    ~ReadLock() {
        if (file_ >= 0) (void)::close(file_);
    }
    ReadLock(const ReadLock&) = delete;
    ReadLock& operator=(const ReadLock&) = delete;

private:
    const int file_;
};

/** The messages that are repeated, and the end of the recording, which others may be later than. */
class WholeRecording final : public replay::TimedSource {
public:
    explicit WholeRecording(replay::Player& player) : player_(player) {}
    std::optional<RTT::nsecs> next() override {
        const std::optional<RTT::nsecs> message = player_.next();
        return message || hasEnded_ ? message : std::optional<RTT::nsecs>(player_.end());
    }
    void deliver() override {
        if (player_.next())
            player_.deliver();
        else
            hasEnded_ = true;
    }

private:
    replay::Player& player_;
    bool hasEnded_ = false;
};

/** Gives the deployers what the recording has. */
class Recorded final : public RecordedPorts {
public:
    /** @param wanted the components that are to be replaced; empty: that is left to their ports. */
    Recorded(replay::Player& player, const std::vector<std::string>& wanted)
        : ports_(player), wanted_(wanted.begin(), wanted.end()) {
        setRecordedPorts(this);
    }
    ~Recorded() override { setRecordedPorts(nullptr); }
    bool hasComponent(const std::string& component) const override { return ports_.hasComponent(component); }
    bool hasPort(const std::string& component, const std::string& port) const override {
        return ports_.hasPort(component, port);
    }
    std::vector<std::string> portsOf(const std::string& component) const override { return ports_.portsOf(component); }
    std::optional<bool> isWanted(const std::string& component) const override {
        return wanted_.empty() ? std::nullopt : std::optional<bool>(wanted_.count(component) != 0);
    }
    void addPorts(RTT::TaskContext& component, std::map<std::string, std::string>& problems) override {
        ports_.addPorts(component, problems);
    }

private:
    schedule::StandIns ports_;
    const std::set<std::string> wanted_;
};

std::string seconds(double value) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(value < 10 ? 3 : 1) << value;
    return text.str();
}

/** Reports a text with its place and its code: "run.mcap: byte 8: error: [MCP003] …". */
void reportLine(const std::string& line) {
    const std::string mark = ": error: [";
    const std::size_t at = line.find(mark), end = line.find("] ", at);
    diag::Diagnostic made;
    made.severity = diag::Severity::Error;
    made.message = line;
    if (at != std::string::npos && end != std::string::npos) {
        made.where.file = line.substr(0, at);
        made.code = line.substr(at + mark.size(), end - at - mark.size());
        made.message = line.substr(end + 2);
    }
    diag::Sink sink;
    sink.add(std::move(made));
    deploy::report(sink);
}

}  // namespace

void standStill() {
    RTT::os::TimeService& time = *RTT::os::TimeService::Instance();
    time.enableSystemClock(false);
    (void)time.ticksChange(-time.getTicks());
}

struct Replay::Impl {
    const Options& options;
    ProgramReport& report;
    std::unique_ptr<replay::Player> player;  // longer than components with its ports
    std::optional<ReadLock> lock;
    std::optional<Recorded> recorded;
    std::optional<schedule::Schedule> schedule;

    std::string noComponent(const std::string& name) const;
    void error(const std::string& file, const char* code, const std::string& text) const;
    void warnOfNothing() const;
    /** Warns of names in --replace that no component has. */
    void warnOfMissing(const DeploymentComponent& deployer) const;
    void summarize(const schedule::Schedule::Outcome& outcome, double passed) const;
    /** For --replay-check: what the schedule has seen of other threads. True if there is nothing. */
    bool reportThreads() const;
};

Replay::Replay(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Replay::~Replay() = default;

std::unique_ptr<Replay> Replay::open(const Options& options, ProgramReport& report) {
    std::unique_ptr<Impl> impl(new Impl{options, report, nullptr, {}, {}, {}});
    std::string error;
    impl->player = openRecording(options.replayFile, options.tolerate, error);
    if (!impl->player) {
        reportLine(error);
        return nullptr;
    }
    std::error_code none;
    if (!options.recordFile.empty() && std::filesystem::equivalent(options.replayFile, options.recordFile, none)) {
        report.error(options.recordFile, "--record would write over the recording that is replayed");
        return nullptr;
    }
    impl->lock.emplace(options.replayFile);
    impl->recorded.emplace(*impl->player, options.replaced);
    for (const std::string& name : options.replaced)
        if (!impl->recorded->hasComponent(name)) {
            impl->error("--replace", "RPL012", impl->noComponent(name));
            return nullptr;
        }
    impl->schedule.emplace(impl->player->begin());
    impl->schedule->setSpeed(options.replaySpeed);
    return std::unique_ptr<Replay>(new Replay(std::move(impl)));
}

bool Replay::run(DeploymentComponent& deployer, RTT::os::SignalCatcher& ending) {
    impl_->warnOfMissing(deployer);
    std::optional<ReplayRecord> record;
    if (!impl_->options.recordFile.empty()) {
        std::string error;
        record.emplace(impl_->options.recordFile, deployer, *impl_->schedule, error);
        if (!error.empty()) {
            impl_->error(impl_->options.recordFile, "RPL007", error);
            return false;
        }
    }
    WholeRecording source(*impl_->player);
    const auto begin = std::chrono::steady_clock::now();
    const schedule::Schedule::Outcome outcome = impl_->schedule->run(source, [&ending] { return ending.caught(); });
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    const bool recorded = !record || record->finish();
    if (!outcome.error.empty()) impl_->error(impl_->options.replayFile, "RPL002", outcome.error);
    const std::vector<std::string> problems = impl_->player->problems();
    for (const std::string& problem : problems) reportLine(problem);
    if (outcome.isComplete && impl_->player->written() == 0 && problems.empty()) impl_->warnOfNothing();
    impl_->summarize(outcome, passed.count());
    const bool exact = !impl_->options.replayCheck || impl_->reportThreads();
    return outcome.error.empty() && problems.empty() && recorded && exact;
}

void Replay::Impl::error(const std::string& file, const char* code, const std::string& text) const {
    diag::Sink sink;
    diag::Location where;
    where.file = file;
    sink.error(where, code, text);
    deploy::report(sink);
}

std::string Replay::Impl::noComponent(const std::string& name) const {
    std::vector<std::string> known;
    for (const replay::Topic& topic : player->topics())
        if (!topic.component.empty()) known.push_back(topic.component);
    return "the recording has no component '" + name + "'" + diag::didYouMean(name, known);
}

void Replay::Impl::warnOfNothing() const {
    diag::Sink sink;
    diag::Location where;
    where.file = options.replayFile;
    sink.warning(
        where, "RPL013",
        "nothing of the recording was replayed: its components run themselves, or are not in the deployment; the "
        "log says why they run, and --replace names what is to be replaced");
    deploy::report(sink);
}

void Replay::Impl::warnOfMissing(const DeploymentComponent& deployer) const {
    diag::Sink sink;
    diag::Location where;
    where.file = "--replace";
    const std::vector<std::string> known = deployer.getPeerList();
    for (const std::string& name : options.replaced)
        if (std::find(known.begin(), known.end(), name) == known.end())
            sink.warning(where, "RPL015",
                         "the deployment has no component '" + name + "', so nothing is replaced by what was recorded" +
                             diag::didYouMean(name, known));
    deploy::report(sink);
}

bool Replay::Impl::reportThreads() const {
    diag::Sink sink;
    for (const std::string& component : schedule->ownThreads())
        sink.error({}, "RPL003", "component '" + component + "' keeps a thread of its own");
    for (const auto& [component, count] : schedule->triggeredByOthers())
        sink.error({}, "RPL011",
                   "component '" + component + "' was triggered by other threads, " + std::to_string(count) +
                       (count == 1 ? " time" : " times") + ": at which time of the recording is not the same again");
    deploy::report(sink);
    return !sink.hadErrors();
}

void Replay::Impl::summarize(const schedule::Schedule::Outcome& outcome, double passed) const {
    const double simulated = RTT::nsecs_to_Seconds(outcome.simulated);
    std::cout << (outcome.isComplete ? "replayed " : "replayed, not to the end, ") << options.replayFile << ": "
              << player->written() << (player->written() == 1 ? " message; " : " messages; ") << seconds(simulated)
              << " s of simulated time in " << seconds(passed) << " s";
    if (passed > 0 && simulated > 0) std::cout << " (" << seconds(simulated / passed) << " times real time)";
    std::cout << std::endl;
}

}  // namespace OCL::deploy
