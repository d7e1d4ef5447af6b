// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "opened_file.hpp"

#include <diag/nearest_match.hpp>
#include <reporting/mcap/scan.hpp>

#include <algorithm>
#include <iostream>
#include <vector>

namespace oroforge::mcap {

/** What describes the messages. */
class OpenedFile::Names : public Visitor {
public:
    explicit Names(OpenedFile& file) : file_(file) {}
    void schema(const Schema& one) override { file_.schemas_.emplace(one.id, one); }
    void channel(const Channel& one) override { file_.channels_.emplace(one.id, one); }
    void problem(const Problem& one) override { file_.report(one); }

private:
    OpenedFile& file_;
};

class OpenedFile::Messages : public Visitor {
public:
    Messages(OpenedFile& file, const std::set<std::uint16_t>& channels,
             const std::function<void(const Message&)>& visit)
        : file_(file), channels_(channels), visit_(visit) {}
    void message(const Message& one) override {
        if (channels_.count(one.channel) != 0) visit_(one);
    }
    void problem(const Problem& one) override { file_.report(one); }

private:
    OpenedFile& file_;
    const std::set<std::uint16_t>& channels_;
    const std::function<void(const Message&)>& visit_;
};

std::unique_ptr<OpenedFile> OpenedFile::open(const std::string& name) {
    std::string why;
    std::unique_ptr<Source> source = openSource(name, why);
    if (!source) {
        std::cerr << name << ": error: " << why << "\n";
        return nullptr;
    }
    std::unique_ptr<OpenedFile> file(new OpenedFile(name, std::move(source)));
    file->learn();
    if (file->reported_.empty() || !file->channels_.empty()) return file;
    return nullptr;
}

void OpenedFile::learn() {
    const Problem problem = readSummary(*source_, summary_);
    hasIndex_ = !problem;
    if (hasIndex_ && describesAll()) {
        schemas_ = summary_.schemas;
        channels_ = summary_.channels;
        return;
    }
    Names names(*this);
    (void)scan(*source_, names);
    summary_.channels = channels_;
    // Of a file that is not whole, scan() says why.
    if (problem && reported_.empty()) report(problem);
}

/** An index need not repeat what describes the messages. */
bool OpenedFile::describesAll() const {
    const auto isDescribed = [this](const auto& one) {
        return one.second.schema == 0 || summary_.schemas.count(one.second.schema) != 0;
    };
    return !summary_.channels.empty() && summary_.channels.size() >= summary_.statistics.channels &&
           std::all_of(summary_.channels.begin(), summary_.channels.end(), isDescribed);
}

void OpenedFile::report(const Problem& problem) {
    isDamaged_ = true;
    const std::string line = problem.line(name_);
    if (reported_.insert(line).second) std::cerr << line << "\n";
}

const Schema* OpenedFile::schemaOf(const Channel& channel) const {
    const auto found = schemas_.find(channel.schema);
    return found == schemas_.end() ? nullptr : &found->second;
}

std::set<std::string> OpenedFile::topics() const {
    std::set<std::string> all;
    for (const auto& [id, channel] : channels_) all.insert(channel.topic);
    return all;
}

void OpenedFile::read(const std::set<std::string>& topics,
                      const std::function<void(const Channel&, const Message&)>& visit) {
    Selection selection;
    for (const auto& [id, channel] : channels_)
        if (topics.empty() || topics.count(channel.topic) != 0) selection.channels.insert(id);
    if (selection.channels.empty()) return;
    const std::function<void(const Message&)> visitOne = [&](const Message& message) {
        visit(channels_.at(message.channel), message);
    };
    if (hasIndex_) {
        readMessages(*source_, summary_, selection, visitOne, [this](const Problem& problem) { report(problem); });
        return;
    }
    Messages messages(*this, selection.channels, visitOne);
    (void)scan(*source_, messages);
}

bool isTopicOf(const OpenedFile& file, const std::string& topic) {
    const std::set<std::string> all = file.topics();
    if (all.count(topic) != 0) return true;
    std::cerr << file.name() << ": error: there is no topic '" << topic << "'"
              << diag::didYouMean(topic, {all.begin(), all.end()}) << "\n";
    return false;
}

}  // namespace oroforge::mcap
