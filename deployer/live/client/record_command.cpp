// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro record
#include "failure.hpp"
#include "interrupts.hpp"
#include "port_patterns.hpp"
#include "recorder.hpp"
#include "session.hpp"

#include <diag/nearest_match.hpp>
#include <reporting/mcap_file/about.hpp>
#include <reporting/mcap_file/packages.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <deque>
#include <set>

#include <sys/stat.h>

namespace oroforge::live_client {
namespace {

constexpr const char* kLog = "rosout";  // matched as a port is
constexpr std::chrono::seconds kBetweenLooks{1};
constexpr std::size_t kAskedAtOnce = 32;
constexpr double kLongest = 3e8, kMostSamples = 10000;
constexpr int kUsualBuffer = 200;

mcap::Compression compressionOf(const std::string& given) {
    std::vector<std::string> names;
    for (const mcap::Compression one : {mcap::Compression::Zstd, mcap::Compression::Lz4})
        if (hasCompression(one)) {
            if (given.empty() || given == nameOf(one)) return one;
            names.emplace_back(nameOf(one));
        }
    if (given == "none") return mcap::Compression::None;
    std::string list;
    for (const std::string& name : names) list += name + ", ";
    names.emplace_back("none");
    throw Failure(Status::Usage, "--compression: found '" + given + "', expected one of " + list + "none" +
                                     diag::didYouMean(given, names));
}

/** "arm_2026-11-27_22-10-05.mcap" */
std::string usualName(std::string deployment) {
    for (char& c : deployment)
        if (std::string("/ :").find(c) != std::string::npos) c = '_';
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    char text[32] = "";
    if (localtime_r(&now, &local)) (void)std::strftime(text, sizeof text, "_%Y-%m-%d_%H-%M-%S", &local);
    return deployment + text + ".mcap";
}

Recorder::Options optionsOf(const Given& given, const std::string& deployment) {
    Recorder::Options options;
    options.compression = compressionOf(given.text("compression"));
    if (!OCL::recording::readSplit(given.text("split"), options.split))
        throw Failure(Status::Usage, "--split: found '" + given.text("split") +
                                         "', expected a size or a time, such as '500 MB' or '60 s'");
    options.file = given.has("output") ? given.text("output") : usualName(deployment);
    if (options.file == "-")
        throw Failure(Status::Usage, "--output: '-' is no file; a recording is not written to standard output");
    options.keepsOthers = !given.has("force");
    struct stat status {};
    if (options.keepsOthers && ::stat(options.file.c_str(), &status) == 0 && S_ISREG(status.st_mode))
        throw Failure(Status::Refused, "'" + options.file + "' exists already; --force overwrites it");
    return options;
}

/** Metadata of the file: those of McapReporting, as far as they are known from outside. */
mcap::Texts aboutOf(const Requests& deployment) {
    mcap::Texts texts;
    if (deployment.pid()) {
        texts = OCL::recording::aboutProcess(deployment.pid());
        texts["packages"] = OCL::recording::packagesOf(deployment.pid());
    }
    texts["component"] = "oro record";
    texts["deployment"] = deployment.name();
    texts["clock"] = "realtime";
    texts["version"] = OROFORGE_VERSION;
    return texts;
}

std::vector<std::string> textsOf(const Json& list) {
    std::vector<std::string> texts;
    for (const Json& one : list)
        if (one.is_string()) texts.push_back(one.get<std::string>());
    return texts;
}

std::string many(std::uint64_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/** The ports that are recorded, and the messages about them. */
class Watcher {
public:
    Watcher(Requests& deployment, PortPatterns patterns, Recorder& recorder, int buffer)
        : deployment_(deployment), patterns_(std::move(patterns)), recorder_(recorder), buffer_(buffer) {
        deployment_.onBytes([this](std::string_view message) { recorder_.addSamples(message); });
    }
    ~Watcher() { deployment_.onBytes({}); }
    Watcher(const Watcher&) = delete;
    Watcher& operator=(const Watcher&) = delete;

    /** Asks for the lines of the log, if they are meant. */
    void followLog() {
        if (patterns_.matches(kLog)) log_ = deployment_.send("log", {{"follow", true}});
    }
    /** Watches those of these ports that are meant and not watched yet. */
    void look(const std::vector<std::string>& outputs) {
        const std::set<std::string> present(outputs.begin(), outputs.end());
        for (auto at = refused_.begin(); at != refused_.end();)
            at = present.count(*at) ? std::next(at) : refused_.erase(at);
        for (const std::string& port : outputs)
            if (patterns_.matches(port) && refused_.count(port) == 0 && known_.insert(port).second)
                wanted_.push_back(port);
        askMore();
    }
    /** Asks which ports there are, unless that is not answered yet. */
    void lookAgain() {
        if (!look_) look_ = deployment_.send("ports", Json::object());
    }
    void take(const Json& message) {
        const long long id = wholeOf(message, "id", -1);
        if (textOf(message, "op") == "oro.line") {
            recorder_.addLine(message);
        } else if (look_ && Requests::answers(message, look_)) {
            look_ = 0;
            look(textsOf(memberOf(Requests::resultOf(message), "outputs")));
        } else if (asked_.count(id)) {
            answered(id, message);
        } else if (watched_.count(id)) {
            // The port has gone; it may come again.
            known_.erase(watched_[id].port);
            watched_.erase(id);
        } else if (ending_.count(id)) {
            if (ending_[id])
                recorder_.endStream(ending_[id],
                                    static_cast<std::uint64_t>(wholeOf(memberOf(message, "result"), "next")));
            ending_.erase(id);
        }
    }
    /** Ends all, and asks for the samples that are there still. */
    void end() {
        wanted_.clear();
        for (const auto& [id, watched] : watched_)
            ending_[deployment_.send("unwatch", {{"watch", id}, {"rest", true}})] = watched.stream;
        watched_.clear();
        if (log_) ending_[deployment_.send("unlog", {{"log", log_}, {"rest", true}})] = 0;
    }
    bool hasEnded() const { return ending_.empty(); }

private:
    struct Watched {
        std::string port;
        std::uint32_t stream;
    };
    void askMore() {
        for (; !wanted_.empty() && asked_.size() < kAskedAtOnce; wanted_.pop_front()) {
            const Json fields = {{"port", wanted_.front()}, {"format", "cdr"}, {"buffer", buffer_}, {"times", true}};
            asked_[deployment_.send("watch", fields)] = wanted_.front();
        }
    }
    void answered(long long id, const Json& message) {
        const std::string port = asked_[id];
        asked_.erase(id);
        std::string why;
        try {
            const Json result = Requests::resultOf(message);
            if (recorder_.addPort(port, result, why))
                watched_[id] = {port, static_cast<std::uint32_t>(wholeOf(result, "stream"))};
        } catch (const Refusal& refusal) {
            why = refusal.what();
        }
        if (watched_.count(id) == 0) {
            remark("'" + printable(port) + "' is not recorded: " + printable(why));
            known_.erase(port);
            refused_.insert(port);
        }
        askMore();
    }

    Requests& deployment_;
    const PortPatterns patterns_;
    Recorder& recorder_;
    const int buffer_;
    std::set<std::string> known_, refused_;  // ports
    std::deque<std::string> wanted_;
    // By the ids of requests.
    std::map<long long, std::string> asked_;
    std::map<long long, Watched> watched_;
    std::map<long long, std::uint32_t> ending_;  // the stream; 0: the log
    long long look_ = 0, log_ = 0;
};

/** Records until `end`, Ctrl-C, or the end of the deployment. */
void record(Requests& deployment, Watcher& watcher, Recorder& recorder, Interrupts& interrupts, Deadline end) {
    Json message;
    Deadline nextLook = Clock::now() + kBetweenLooks;
    while (Clock::now() < end) {
        const auto event = deployment.next(message, std::min({end, nextLook, recorder.due()}));
        if (event == Requests::Event::Woken) break;
        if (event == Requests::Event::Message) watcher.take(message);
        recorder.writeDue();
        if (Clock::now() < nextLook) continue;
        watcher.lookAgain();
        nextLook = Clock::now() + kBetweenLooks;
    }
    (void)interrupts.take();  // the next one does not wait for what the deployment has still
    watcher.end();
    const Deadline patience = deadlineIn(deployment.limit());
    while (!watcher.hasEnded()) {
        if (Clock::now() < patience && deployment.next(message, patience) == Requests::Event::Message) {
            watcher.take(message);
            continue;
        }
        remark("the samples that wait in the deployment are not in the file");
        break;
    }
}

void report(Session& session, const Recorder& recorder, const std::string& file, double seconds) {
    if (session.json())
        return session.out().line(lineOf({{"file", file},
                                          {"files", recorder.files()},
                                          {"topics", recorder.topics()},
                                          {"messages", recorder.messages()},
                                          {"lost", recorder.lost()},
                                          {"bytes", recorder.bytes()},
                                          {"seconds", seconds}}));
    char time[32];
    std::snprintf(time, sizeof time, "%.1f s", seconds);
    const std::string files = recorder.files() > 1 ? " and " + many(recorder.files() - 1, "more file") : "";
    session.out().line(printable(file) + files + ": " + many(recorder.messages(), "message") + " of " +
                       many(recorder.topics(), "topic") + ", " + std::to_string(recorder.lost()) + " lost, " +
                       many(recorder.bytes(), "byte") + ", " + time);
}

/** Throws a Failure if nothing is meant by the words. */
void checkPatterns(const std::vector<std::string>& words, const std::vector<std::string>& outputs) {
    std::vector<std::string> names = outputs;
    names.emplace_back(kLog);
    const std::vector<std::string> none = PortPatterns(words).unmatched(names);
    if (none.empty()) return;
    constexpr std::size_t kMostNamed = 5;
    std::string text = "no output port matches '" + none.front() + "'" + diag::didYouMean(none.front(), outputs);
    if (none.size() < words.size()) return remark(printable(text + "; it is recorded if it comes"));
    text += outputs.empty() ? "; there are no output ports" : "; there are ";
    for (std::size_t i = 0; i != std::min(outputs.size(), kMostNamed); ++i) text += (i ? ", " : "") + outputs[i];
    throw Failure(Status::Refused, text + (outputs.size() > kMostNamed ? " and others" : ""));
}

}  // namespace

void recordPorts(Session& session) {
    const Given& given = session.given();
    const double seconds = given.number("duration", 0, 0.001, kLongest);
    const int buffer = static_cast<int>(given.number("buffer", kUsualBuffer, 1, kMostSamples));
    Requests& deployment = session.deployment();
    const Recorder::Options options = optionsOf(given, deployment.name());
    Interrupts interrupts;
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large is an error of write()
    const auto outputs = textsOf(memberOf(deployment.ask("ports"), "outputs"));
    checkPatterns(given.words, outputs);
    deployment.connection().wakeOn({interrupts.descriptor()});
    Recorder recorder(options, aboutOf(deployment));
    Watcher watcher(deployment, PortPatterns(given.words), recorder, buffer);
    remark("recording to '" + printable(options.file) + "'; Ctrl-C ends it");
    const Deadline begin = Clock::now();
    const auto written = [&] {
        report(session, recorder, options.file, std::chrono::duration<double>(Clock::now() - begin).count());
    };
    try {
        watcher.followLog();
        watcher.look(outputs);
        const auto limit = std::chrono::milliseconds(static_cast<long long>(seconds * 1000));
        record(deployment, watcher, recorder, interrupts, seconds > 0 ? deadlineIn(limit) : kNever);
    } catch (const Ended& ended) {
        remark(printable(ended.what()) + "; the recording ends");
    } catch (const Failure&) {
        written();
        throw;
    }
    recorder.finish();
    written();
}

}  // namespace oroforge::live_client
