// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_TOOL_OPENED_FILE_HPP
#define OROFORGE_MCAP_TOOL_OPENED_FILE_HPP

#include <reporting/mcap/records.hpp>
#include <reporting/mcap/source.hpp>
#include <reporting/mcap/summary.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace oroforge::mcap {

/** A recording that is read. What is damaged goes to standard error. */
class OpenedFile {
public:
    /** Null, with the error on standard error, if it cannot be read at all. */
    static std::unique_ptr<OpenedFile> open(const std::string& name);

    const std::string& name() const { return name_; }
    Source& source() { return *source_; }
    const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
    /** Null if the file does not describe this channel. */
    const Schema* schemaOf(const Channel& channel) const;
    std::set<std::string> topics() const;
    /** Part of the file could not be read. */
    bool isDamaged() const { return isDamaged_; }

    /** Visits the messages of these topics, all if there are none: in the order of times if the file has its end,
        otherwise in that of the file. */
    void read(const std::set<std::string>& topics, const std::function<void(const Channel&, const Message&)>& visit);

private:
    class Names;
    class Messages;
    OpenedFile(std::string name, std::unique_ptr<Source> source) : name_(std::move(name)), source_(std::move(source)) {}
    void learn();
    bool describesAll() const;
    void report(const Problem& problem);

    const std::string name_;
    const std::unique_ptr<Source> source_;
    Summary summary_;
    bool hasIndex_ = false, isDamaged_ = false;
    std::set<std::string> reported_;
    std::map<std::uint16_t, Schema> schemas_;
    std::map<std::uint16_t, Channel> channels_;
};

/** The error of an argument that is no topic of the file, with the nearest one. */
bool isTopicOf(const OpenedFile& file, const std::string& topic);

}  // namespace oroforge::mcap

#endif
