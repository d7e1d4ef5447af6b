// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"
#include "leaves.hpp"
#include "opened_file.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <vector>

namespace oroforge::mcap {
namespace {

struct Kept {
    std::uint64_t time;
    Bytes data;
};

std::vector<Kept> messagesOf(OpenedFile& file, const std::string& topic) {
    std::vector<Kept> all;
    file.read({topic}, [&](const Channel&, const Message& message) {
        all.push_back({message.logTime, {message.data, message.data + message.size}});
    });
    return all;
}

const Channel& channelOf(const OpenedFile& file, const std::string& topic) {
    const auto found = std::find_if(file.channels().begin(), file.channels().end(),
                                    [&](const auto& one) { return one.second.topic == topic; });
    return found->second;
}

/** Two files whose topics are compared one after the other. */
class Comparison {
public:
    Comparison(OpenedFile& one, OpenedFile& other) : one_(one), other_(other), decoders_(one.name()) {}

    void compare(const std::string& topic) {
        const Channel& channel = channelOf(one_, topic);
        const Schema* const schema = one_.schemaOf(channel);
        const Schema* const otherSchema = other_.schemaOf(channelOf(other_, topic));
        const bool sameSchema = (schema ? schema->data : "") == (otherSchema ? otherSchema->data : "");
        if (!sameSchema) {
            differ(0, topic, "the type is described by another text");
            return;
        }
        const std::vector<Kept> ours = messagesOf(one_, topic), theirs = messagesOf(other_, topic);
        const std::size_t common = std::min(ours.size(), theirs.size());
        for (std::size_t i = 0; i != common; ++i) {
            if (ours[i].time != theirs[i].time)
                return differ(ours[i].time, topic,
                              "message " + std::to_string(i) + " is of " + secondsOf(ours[i].time) +
                                  " in the first and " + secondsOf(theirs[i].time) + " in the second");
            if (ours[i].data != theirs[i].data)
                return differ(ours[i].time, topic,
                              "message " + std::to_string(i) + " at " + secondsOf(ours[i].time) + ": " +
                                  fieldsOf(channel, schema, ours[i], theirs[i]));
        }
        if (ours.size() != theirs.size()) {
            const Kept& next = ours.size() > common ? ours[common] : theirs[common];
            differ(next.time, topic,
                   "there are " + std::to_string(ours.size()) + " messages in the first and " +
                       std::to_string(theirs.size()) + " in the second, and those that both have are equal");
        }
    }
    void differ(std::uint64_t time, const std::string& topic, const std::string& how) {
        found_.emplace(time, topic + ": " + how);
    }
    /** The earliest first. */
    const std::multimap<std::uint64_t, std::string>& found() const { return found_; }

private:
    std::string fieldsOf(const Channel& channel, const Schema* schema, const Kept& ours, const Kept& theirs) {
        Leaves one, other;
        const auto take = [&](const Kept& kept, Leaves& leaves) {
            Message message;
            message.logTime = kept.time;
            message.data = kept.data.data();
            message.size = kept.data.size();
            return decoders_.walk(channel, schema, message, leaves);
        };
        if (!take(ours, one) || !take(theirs, other)) return "the bytes are different";
        for (std::size_t i = 0; i != std::min(one.all.size(), other.all.size()); ++i) {
            const Leaf &first = one.all[i], &second = other.all[i];
            if (first.path != second.path) return "a list before '" + first.path + "' has another size";
            if (first.value != second.value)
                return "'" + first.path + "' is " + first.value + " in the first and " + second.value +
                       " in the second";
        }
        return one.all.size() == other.all.size() ? "the bytes are different" : "the last list has another size";
    }

    OpenedFile& one_;
    OpenedFile& other_;
    Decoders decoders_;
    std::multimap<std::uint64_t, std::string> found_;
};

}  // namespace

int diff(const ToolOptions& options) {
    const std::unique_ptr<OpenedFile> one = OpenedFile::open(options.files[0]);
    const std::unique_ptr<OpenedFile> other = OpenedFile::open(options.files[1]);
    if (!one || !other) return kFailed;
    std::set<std::string> topics(options.topics.begin(), options.topics.end());
    const std::set<std::string> ours = one->topics(), theirs = other->topics();
    if (topics.empty()) {
        topics = ours;
        topics.insert(theirs.begin(), theirs.end());
    }
    Comparison comparison(*one, *other);
    for (const std::string& topic : topics) {
        if (ours.count(topic) == 0 && theirs.count(topic) == 0) {
            (void)isTopicOf(*one, topic);
            return kFailed;
        }
        if (ours.count(topic) == 0 || theirs.count(topic) == 0)
            comparison.differ(0, topic, ours.count(topic) != 0 ? "only the first has it" : "only the second has it");
        else
            comparison.compare(topic);
    }
    for (const auto& [time, text] : comparison.found()) std::cout << text << "\n";
    const bool isGood = comparison.found().empty() && !one->isDamaged() && !other->isDamaged();
    return isGood ? kGood : kDamaged;
}

}  // namespace oroforge::mcap
