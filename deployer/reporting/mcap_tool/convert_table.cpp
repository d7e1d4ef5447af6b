// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// All topics in one table, as OCL::FileReporting writes it: a row for each time, with the last values.
#include "commands.hpp"
#include "leaves.hpp"
#include "new_file.hpp"
#include "opened_file.hpp"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace oroforge::mcap {
namespace {

std::string escaped(const std::string& text) {
    if (text.empty()) return "\"\"";
    std::string line;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '\n' || c == '\t' || c == '\\') {
            line += '\\';
            line += c == '\n' ? 'n' : c == '\t' ? 't' : '\\';
        } else if (code <= ' ' || code == 0x7f || c == '"' || c == '#') {
            char shown[8];
            (void)std::snprintf(shown, sizeof shown, "\\x%02x", static_cast<unsigned>(code));
            line += shown;
        } else {
            line += c;
        }
    }
    return line;
}

/** Six digits, whatever the locale. */
std::string digitsOf(double number) {
    constexpr int kDigits = 6;
    char text[32];
    const auto end = std::to_chars(std::begin(text), std::end(text), number, std::chars_format::general, kDigits).ptr;
    return {std::begin(text), end};
}

std::string fieldOf(const Leaf& leaf) {
    if (leaf.isText) return escaped(leaf.value);
    if (leaf.type == schema::Basic::Bool) return leaf.value == "true" ? "1" : "0";
    const bool isReal = leaf.type == schema::Basic::Float32 || leaf.type == schema::Basic::Float64;
    return isReal ? digitsOf(std::strtod(leaf.value.c_str(), nullptr)) : leaf.value;
}

/** "levels[0].x" is "levels.0.x". */
std::string columnOf(const std::string& name) {
    std::string column;
    for (const char c : name)
        if (c != ']') column += c == '[' ? '.' : c;
    return escaped(column);
}

/** The columns, and the row that is made. */
class Rows {
public:
    void note(const Channel& channel, const Leaves& leaves) {
        std::map<std::string, std::size_t>& its = columns_[channel.id];
        for (const Leaf& leaf : leaves.all)
            if (its.emplace(leaf.path, fields_.size()).second) {
                fields_.emplace_back("nan");
                header_ += " " + columnOf(nameOf(sourceOf(channel), leaf.path));
            }
    }
    std::string header() const { return " TimeStamp" + header_ + "\n"; }

    void take(const Channel& channel, const Leaves& leaves) {
        std::map<std::string, std::size_t>& its = columns_[channel.id];
        // An element that the list has no longer has no value.
        for (const auto& [path, column] : its) fields_[column] = "nan";
        for (const Leaf& leaf : leaves.all) fields_[its.at(leaf.path)] = fieldOf(leaf);
    }
    std::string row(double seconds) const {
        std::string line = " " + digitsOf(seconds);
        for (const std::string& field : fields_) line += " " + field;
        return line + " \n";
    }

private:
    std::map<std::uint16_t, std::map<std::string, std::size_t>> columns_;  // by path
    std::vector<std::string> fields_;
    std::string header_;
};

/** Those that were given; otherwise all but the recorder's own, which no reporter writes. */
std::set<std::string> topicsOf(const OpenedFile& file, const ToolOptions& options) {
    std::set<std::string> topics(options.topics.begin(), options.topics.end());
    if (!topics.empty()) return topics;
    for (const auto& [id, channel] : file.channels()) {
        const auto kind = channel.metadata.find("oroforge.kind");
        const bool isOwn = kind != channel.metadata.end() && (kind->second == "log" || kind->second == "states");
        if (!isOwn) topics.insert(channel.topic);
    }
    return topics;
}

}  // namespace

int convertToTable(const ToolOptions& options) {
    const std::unique_ptr<OpenedFile> file = OpenedFile::open(options.files[0]);
    if (!file) return kFailed;
    for (const std::string& topic : options.topics)
        if (!isTopicOf(*file, topic)) return kFailed;
    const std::set<std::string> topics = topicsOf(*file, options);
    Decoders decoders(file->name());
    const auto read = [&](auto&& use) {
        file->read(topics, [&](const Channel& channel, const Message& message) {
            Leaves leaves;
            if (decoders.walk(channel, file->schemaOf(channel), message, leaves)) use(channel, message, leaves);
        });
    };
    Rows rows;
    read([&](const Channel& channel, const Message&, const Leaves& leaves) { rows.note(channel, leaves); });
    const std::unique_ptr<LineOutput> output = LineOutput::make(options.output);
    if (!output) return kFailed;
    output->write(rows.header());
    bool hasRow = false;
    std::uint64_t begin = 0, time = 0;
    const auto writeRow = [&] {
        output->write(rows.row((static_cast<double>(time) - static_cast<double>(begin)) / 1e9));
    };
    read([&](const Channel& channel, const Message& message, const Leaves& leaves) {
        if (!hasRow) begin = message.logTime;
        if (hasRow && message.logTime != time) writeRow();
        hasRow = true;
        time = message.logTime;
        rows.take(channel, leaves);
    });
    if (hasRow) writeRow();
    if (!output->finish()) return kFailed;
    return file->isDamaged() || decoders.failed() ? kDamaged : kGood;
}

}  // namespace oroforge::mcap
