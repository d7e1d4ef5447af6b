// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"
#include "leaves.hpp"
#include "new_file.hpp"
#include "opened_file.hpp"

#include <iostream>
#include <map>
#include <vector>

namespace oroforge::mcap {
namespace {

/** In quotation marks if it must be (RFC 4180). */
void appendField(std::string& line, const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        line += text;
        return;
    }
    line += '"';
    for (const char c : text) line.append(c == '"' ? 2 : 1, c);
    line += '"';
}

/** The topic to convert; empty, with an error, if that is not clear. */
std::string topicOf(const OpenedFile& file, const ToolOptions& options) {
    if (options.topics.size() == 1) return isTopicOf(file, options.topics[0]) ? options.topics[0] : "";
    const std::set<std::string> all = file.topics();
    if (options.topics.empty() && all.size() == 1) return *all.begin();
    std::cerr << file.name() << ": error: a table has one topic; name it with --topic:";
    for (const std::string& topic : all) std::cerr << " " << topic;
    std::cerr << "\n";
    return {};
}

/** A column for each number or text that any message has, in the order in which they come. */
class Table {
public:
    void note(const Leaves& leaves) {
        for (const Leaf& leaf : leaves.all)
            if (columns_.emplace(leaf.path, names_.size()).second) names_.push_back(leaf.path);
    }
    std::string header() const {
        std::string line = "time";
        for (const std::string& name : names_) {
            line += ',';
            appendField(line, name);
        }
        return line + "\n";
    }
    std::string row(std::uint64_t time, const Leaves& leaves) const {
        std::vector<const Leaf*> cells(names_.size());
        for (const Leaf& leaf : leaves.all) cells[columns_.at(leaf.path)] = &leaf;
        std::string line = secondsOf(time);
        for (const Leaf* const cell : cells) {
            line += ',';
            if (cell) appendField(line, cell->value);
        }
        return line + "\n";
    }

private:
    std::map<std::string, std::size_t> columns_;
    std::vector<std::string> names_;
};

}  // namespace

namespace {

int convertToCsv(const ToolOptions& options) {
    const std::unique_ptr<OpenedFile> file = OpenedFile::open(options.files[0]);
    if (!file) return kFailed;
    const std::string topic = topicOf(*file, options);
    if (topic.empty()) return kFailed;
    Decoders decoders(file->name());
    Table table;
    const auto read = [&](auto&& use) {
        file->read({topic}, [&](const Channel& channel, const Message& message) {
            Leaves leaves;
            if (decoders.walk(channel, file->schemaOf(channel), message, leaves)) use(message, leaves);
        });
    };
    read([&](const Message&, const Leaves& leaves) { table.note(leaves); });
    const std::unique_ptr<LineOutput> output = LineOutput::make(options.output);
    if (!output) return kFailed;
    output->write(table.header());
    read([&](const Message& message, const Leaves& leaves) { output->write(table.row(message.logTime, leaves)); });
    if (!output->finish()) return kFailed;
    return file->isDamaged() || decoders.failed() ? kDamaged : kGood;
}

std::string formatOf(const ToolOptions& options) {
    if (!options.format.empty()) return options.format;
    const std::size_t point = options.output.rfind('.');
    const std::string suffix = point == std::string::npos ? "" : options.output.substr(point);
    return suffix == ".nc" ? "netcdf" : suffix == ".dat" ? "table" : "csv";
}

}  // namespace

int convert(const ToolOptions& options) {
    const std::string format = formatOf(options);
    if (format == "csv") return convertToCsv(options);
    if (format == "table") return convertToTable(options);
    if (format == "netcdf") return convertToNetcdf(options);
    std::cerr << "oro-mcap: error: --to: found '" << format << "', expected csv, table or netcdf\n";
    return kFailed;
}

}  // namespace oroforge::mcap
