// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_TOOL_LEAVES_HPP
#define OROFORGE_MCAP_TOOL_LEAVES_HPP

#include <reporting/mcap/records.hpp>
#include <reporting/schema/message_schema.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace oroforge::mcap {

/** A number or text in a message. */
struct Leaf {
    std::string path;  ///< "pose.points[2].x"
    std::string value;
    bool isText = false;
    schema::Basic type = schema::Basic::Text;
};

/** The numbers and texts of a message, and the sizes of its empty lists. */
class Leaves : public schema::PartTaker {
public:
    std::vector<Leaf> all;

    void beginStruct() override { open(); }
    void field(std::string_view name) override {
        path_.resize(ends_.back());
        if (!path_.empty()) path_ += '.';
        path_ += name;
    }
    void endStruct() override { close(); }
    void beginList() override { open(); }
    void element(std::size_t index) override {
        path_.resize(ends_.back());
        path_ += '[' + std::to_string(index) + ']';
    }
    void endList() override { close(); }
    void number(std::string_view) override {}
    void typedNumber(schema::Basic type, std::string_view text) override {
        all.push_back({path_, std::string(text), false, type});
    }
    void text(std::string_view text) override { all.push_back({path_, std::string(text), true}); }

private:
    void open() { ends_.push_back(path_.size()); }
    void close() {
        path_.resize(ends_.back());
        ends_.pop_back();
    }

    std::string path_;
    std::vector<std::size_t> ends_;  // of the paths of what is open
};

/** The schemas of the channels of a file. Why one cannot be read is on standard error, once. */
class Decoders {
public:
    explicit Decoders(std::string file) : file_(std::move(file)) {}
    /** Null if messages of this channel cannot be taken apart. */
    const schema::MessageSchema* of(const Channel& channel, const Schema* described);
    /** False, with an error on standard error, if the bytes do not fit. */
    bool walk(const Channel& channel, const Schema* described, const Message& message, schema::PartTaker& taker);
    /** Some message could not be taken apart. */
    bool failed() const { return failed_; }

private:
    const std::string file_;
    std::map<std::uint16_t, std::pair<bool, schema::MessageSchema>> known_;
    std::map<std::uint16_t, std::uint64_t> reportedUntil_;  // by channel: the time of the last message that did not fit
    bool failed_ = false;
};

/** The name of a topic as the reporters have it: "arm.pose" for "/arm/pose". */
std::string sourceOf(const Channel& channel);
/** The name of a leaf as the reporters have it. The field `data`, which is around a number, text or list because a
    message must be a struct, is left out. */
std::string nameOf(const std::string& source, const std::string& path);

/** Nanoseconds as seconds: "1.500000000". */
std::string secondsOf(std::uint64_t time);

}  // namespace oroforge::mcap

#endif
