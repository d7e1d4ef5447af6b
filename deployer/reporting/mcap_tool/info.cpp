// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"
#include "leaves.hpp"

#include <reporting/mcap/scan.hpp>
#include <reporting/mcap/source.hpp>
#include <reporting/mcap/summary.hpp>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>

namespace oroforge::mcap {
namespace {

/** Letters of a UTF-8 text. */
std::size_t lettersOf(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

/** What a file has, and what is wrong with it. */
class Counts : public Visitor {
public:
    explicit Counts(const std::string& file) : file_(file) {}

    void header(const Header& one) override { header_ = one; }
    void schema(const Schema& one) override { schemas_[one.id] = one; }
    void channel(const Channel& one) override { channels_[one.id].channel = one; }
    void chunk(const ChunkHead& head, const Bytes&, std::uint64_t) override {
        ++chunks_;
        compressions_.insert(head.compression.empty() ? "none" : head.compression);
    }
    void message(const Message& message) override {
        Of& of = channels_[message.channel];
        if (of.messages != 0 && message.sequence > of.next) of.gaps += message.sequence - of.next;
        of.next = message.sequence + 1;
        for (Of* const one : {&of, &all_}) {
            one->first = one->messages == 0 ? message.logTime : std::min(one->first, message.logTime);
            one->last = std::max(one->last, message.logTime);
            ++one->messages;
        }
    }
    void metadata(const Metadata& one) override { metadata_.push_back(one); }
    void problem(const Problem& one) override {
        const bool isOther = one.code == std::string("MCP001");
        isRecording_ = isRecording_ && !isOther;
        std::cerr << one.line(file_) << "\n";
    }

    bool isRecording() const { return isRecording_; }
    void print(std::uint64_t size) const {
        std::cout << "file        " << file_ << ", " << size << " bytes\n"
                  << "writer      " << header_.library << ", profile '" << header_.profile << "'\n"
                  << "messages    " << all_.messages << " in " << chunks_ << " chunks, compression ";
        for (const std::string& one : compressions_) std::cout << (one == *compressions_.begin() ? "" : ", ") << one;
        std::cout << (compressions_.empty() ? "none\n" : "\n");
        if (all_.messages != 0)
            std::cout << "from        " << dateOf(all_.first) << "\nto          " << dateOf(all_.last) << ", "
                      << secondsOf(all_.last - all_.first) << " s\n";
        for (const Metadata& one : metadata_) {
            std::cout << "metadata    " << one.name << ":";
            for (const auto& [name, value] : one.texts) std::cout << " " << name << "=" << shortened(value);
            std::cout << "\n";
        }
        printTopics();
    }

private:
    /** Files are in the metadata, too. */
    static std::string shortened(const std::string& value) {
        constexpr std::size_t kMost = 200;
        const bool isLine = value.size() <= kMost && value.find('\n') == std::string::npos;
        return isLine ? value : "(" + std::to_string(value.size()) + " bytes)";
    }

    struct Of {
        Channel channel;
        std::uint64_t messages = 0, first = 0, last = 0, gaps = 0;
        std::uint32_t next = 0;
    };

    void printTopics() const {
        std::size_t topic = 5, type = 4;
        for (const auto& [id, of] : channels_) {
            topic = std::max(topic, lettersOf(of.channel.topic));
            type = std::max(type, lettersOf(typeOf(of.channel)));
        }
        const auto line = [&](const std::string& one, const std::string& other) -> std::ostream& {
            return std::cout << one << std::string(topic - lettersOf(one) + 2, ' ') << other
                             << std::string(type - lettersOf(other), ' ');
        };
        line("topic", "type") << "  messages  missing\n";
        for (const auto& [id, of] : channels_)
            line(of.channel.topic, typeOf(of.channel))
                << "  " << std::setw(8) << of.messages << "  " << std::setw(7) << of.gaps << "\n";
    }

    std::string typeOf(const Channel& channel) const {
        const auto found = schemas_.find(channel.schema);
        return found == schemas_.end() ? "-" : found->second.name;
    }

    /** Times that cannot be those since 1970 are seconds. */
    static std::string dateOf(std::uint64_t time) {
        constexpr std::uint64_t kSecond = 1000000000, kYear2000 = 946684800;
        const auto seconds = static_cast<std::time_t>(time / kSecond);
        std::tm parts{};
        char text[32] = "";
        if (time / kSecond < kYear2000 || !gmtime_r(&seconds, &parts)) return secondsOf(time) + " s";
        (void)std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
        return text + secondsOf(time).substr(secondsOf(time).size() - 10) + "Z";
    }

    const std::string& file_;
    Header header_;
    std::map<std::uint16_t, Schema> schemas_;
    std::map<std::uint16_t, Of> channels_;
    std::set<std::string> compressions_;
    std::vector<Metadata> metadata_;
    std::uint64_t chunks_ = 0;
    Of all_;
    bool isRecording_ = true;
};

}  // namespace

int info(const ToolOptions& options) {
    const std::string& file = options.files[0];
    std::string why;
    const std::unique_ptr<Source> source = openSource(file, why);
    if (!source) {
        std::cerr << file << ": error: " << why << "\n";
        return kFailed;
    }
    Counts counts(file);
    const Scanned scanned = scan(*source, counts);
    if (!counts.isRecording()) return kFailed;
    Problem index;
    Summary summary;
    // What is wrong with the end of a file that is cut is reported already.
    if (scanned.problems == 0 && (index = readSummary(*source, summary))) counts.problem(index);
    counts.print(source->size());
    return scanned.problems == 0 && !index ? kGood : kDamaged;
}

}  // namespace oroforge::mcap
