// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Each topic has a dimension of its own, with the times of its messages, and variables for what is in them.
#include "commands.hpp"
#include "leaves.hpp"
#include "netcdf_writer.hpp"
#include "opened_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace oroforge::mcap {
namespace {

using schema::Basic;

/** More variables are no data that a person looks at. */
constexpr std::size_t kMostVariables = 65536;
/** Each text takes as much as the longest of its field, and each list as the longest one. */
constexpr double kMostBytes = 1e11;

NetcdfType typeOf(Basic basic) {
    switch (basic) {
        case Basic::Bool:
        case Basic::Int8: return NetcdfType::Byte;
        case Basic::UInt8: return NetcdfType::UByte;
        case Basic::Int16: return NetcdfType::Short;
        case Basic::UInt16: return NetcdfType::UShort;
        case Basic::Int32: return NetcdfType::Int;
        case Basic::UInt32: return NetcdfType::UInt;
        case Basic::Int64: return NetcdfType::Int64;
        case Basic::UInt64: return NetcdfType::UInt64;
        case Basic::Float32: return NetcdfType::Float;
        case Basic::Float64: return NetcdfType::Double;
        default: return NetcdfType::Char;
    }
}

void putNumber(Bytes& out, NetcdfType type, const std::string& text) {
    if (type == NetcdfType::Float || type == NetcdfType::Double) {
        const double number = std::strtod(text.c_str(), nullptr);
        const auto small = static_cast<float>(number);
        std::uint32_t few = 0;
        std::uint64_t many = 0;
        std::memcpy(&few, &small, sizeof few);
        std::memcpy(&many, &number, sizeof many);
        if (type == NetcdfType::Float)
            putBig(out, few);
        else
            putBig(out, many);
        return;
    }
    std::uint64_t bits = text == "true" ? 1 : 0;
    std::int64_t number = 0;
    if (text[0] == '-' && std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc())
        bits = static_cast<std::uint64_t>(number);
    else
        (void)std::from_chars(text.data(), text.data() + text.size(), bits);
    for (std::size_t i = sizeOf(type); i-- > 0;) out.push_back(static_cast<unsigned char>(bits >> (8 * i)));
}

/** What stands for no value: of integers, that which the library has for their type. */
Bytes fillOf(NetcdfType type) {
    const std::map<NetcdfType, std::string> fills = {{NetcdfType::Byte, "-127"},
                                                     {NetcdfType::UByte, "255"},
                                                     {NetcdfType::Short, "-32767"},
                                                     {NetcdfType::UShort, "65535"},
                                                     {NetcdfType::Int, "-2147483647"},
                                                     {NetcdfType::UInt, "4294967295"},
                                                     {NetcdfType::Float, "nan"},
                                                     {NetcdfType::Double, "nan"},
                                                     {NetcdfType::Char, "0"},
                                                     {NetcdfType::Int64, "-9223372036854775806"},
                                                     {NetcdfType::UInt64, "18446744073709551614"}};
    Bytes fill;
    putNumber(fill, type, fills.at(type));
    return fill;
}

/** Names that NetCDF and its tools take, each once. */
class FreeNames {
public:
    std::string take(const std::string& wanted) {
        constexpr std::size_t kLongest = 230;
        std::string base = wanted.substr(0, kLongest);
        for (char& c : base)
            if (c <= ' ' || c >= '\x7f' || c == '/') c = '_';
        if (base.empty() || (std::isalnum(static_cast<unsigned char>(base[0])) == 0 && base[0] != '_'))
            base = "_" + base;
        std::string name = base;
        for (int number = 2; !taken_.insert(name).second; ++number) name = base + "_" + std::to_string(number);
        return name;
    }

private:
    std::set<std::string> taken_;
};

/** A number or text of all messages of a topic, or a list of numbers. */
struct Column {
    NetcdfType type = NetcdfType::Double;
    bool isList = false;
    std::size_t elements = 1;  // of the longest list or text
    std::uint64_t values = 0;
    std::size_t variable = 0;
    Bytes fill, row;
};

/** A list of numbers is one column: "levels[2]" is the place 2 in "levels". */
std::string columnOf(const Leaf& leaf, std::size_t& place) {
    place = 0;
    if (leaf.isText || leaf.path.empty() || leaf.path.back() != ']') return leaf.path;
    const std::size_t open = leaf.path.rfind('[');
    place = std::strtoul(leaf.path.c_str() + open + 1, nullptr, 10);
    return leaf.path.substr(0, open);
}

class Topic {
public:
    explicit Topic(const Channel& channel) : channel_(channel) {}

    void note(std::uint64_t time, const Leaves& leaves) {
        first_ = messages_ == 0 ? time : std::min(first_, time);
        ++messages_;
        for (const Leaf& leaf : leaves.all) {
            std::size_t place = 0;
            const auto [at, isNew] = columns_.try_emplace(columnOf(leaf, place));
            Column& column = at->second;
            if (isNew) order_.push_back(at->first);
            column.type = typeOf(leaf.type);
            column.isList = !leaf.isText && at->first != leaf.path;
            column.elements = std::max({column.elements, leaf.isText ? leaf.value.size() : 1, place + 1});
            ++column.values;
        }
    }
    std::size_t size() const { return columns_.size() + 1; }
    /** What it takes in a file. */
    double bytes() const {
        double row = 8;
        for (const auto& [path, column] : columns_) row += static_cast<double>(column.elements * sizeOf(column.type));
        return row * static_cast<double>(messages_);
    }

    void define(NetcdfWriter& writer, FreeNames& names, bool isOnly) {
        const std::string prefix = isOnly ? "" : sourceOf(channel_) + ".";
        const std::string time = names.take(prefix + "time");
        const std::size_t rows = writer.addDimension(time, messages_);
        constexpr std::uint64_t kYear2000 = 946684800000000000;
        const char* const unit = first_ < kYear2000 ? "nanoseconds" : "nanoseconds since 1970-01-01 00:00:00";
        time_ = writer.addVariable(
            {time, NetcdfType::Int64, {rows}, {{"units", unit}, {"standard_name", "time"}, {"axis", "T"}}, {}});
        for (const std::string& path : order_) {
            Column& column = columns_.at(path);
            NetcdfVariable variable;
            variable.name = names.take(isOnly ? path : nameOf(sourceOf(channel_), path));
            variable.type = column.type;
            variable.dimensions = {rows};
            const bool isText = column.type == NetcdfType::Char;
            const std::string end = isText ? "_len" : "_dim";
            if (isText || column.isList)
                variable.dimensions.push_back(writer.addDimension(names.take(variable.name + end), column.elements));
            const auto unitOf = channel_.metadata.find("unit." + path);
            if (unitOf != channel_.metadata.end() && !isText) variable.texts.emplace_back("units", unitOf->second);
            if (isText) variable.texts.emplace_back("_Encoding", "utf-8");
            column.fill = fillOf(column.type);
            if (!isText && column.values != messages_ * column.elements) variable.fill = column.fill;
            column.variable = writer.addVariable(std::move(variable));
        }
    }

    std::string write(NetcdfWriter& writer, std::uint64_t time, const Leaves& leaves) {
        for (auto& [path, column] : columns_) {
            column.row.clear();
            for (std::size_t i = 0; i != column.elements; ++i)
                column.row.insert(column.row.end(), column.fill.begin(), column.fill.end());
        }
        Bytes bytes;
        for (const Leaf& leaf : leaves.all) {
            std::size_t place = 0;
            Column& column = columns_.at(columnOf(leaf, place));
            bytes.assign(leaf.value.begin(), leaf.value.end());
            if (!leaf.isText) {
                bytes.clear();
                putNumber(bytes, column.type, leaf.value);
            }
            std::copy(bytes.begin(), bytes.end(),
                      column.row.begin() + static_cast<std::ptrdiff_t>(place * sizeOf(column.type)));
        }
        bytes.clear();
        putBig(bytes, time);
        std::string error = writer.append(time_, bytes);
        for (auto at = columns_.begin(); at != columns_.end() && error.empty(); ++at)
            error = writer.append(at->second.variable, at->second.row);
        return error;
    }

private:
    const Channel channel_;
    std::uint64_t messages_ = 0, first_ = 0;
    std::map<std::string, Column> columns_;
    std::vector<std::string> order_;
    std::size_t time_ = 0;  // the variable
};

}  // namespace

int convertToNetcdf(const ToolOptions& options) {
    if (options.output.empty()) {
        std::cerr << "oro-mcap: error: a NetCDF file is not printed; name it with -o\n";
        return kFailed;
    }
    const std::unique_ptr<OpenedFile> file = OpenedFile::open(options.files[0]);
    if (!file) return kFailed;
    for (const std::string& topic : options.topics)
        if (!isTopicOf(*file, topic)) return kFailed;
    Decoders decoders(file->name());
    const auto read = [&](auto&& use) {
        file->read({options.topics.begin(), options.topics.end()}, [&](const Channel& channel, const Message& message) {
            Leaves leaves;
            if (decoders.walk(channel, file->schemaOf(channel), message, leaves)) use(channel, message, leaves);
        });
    };
    std::map<std::uint16_t, Topic> topics;
    read([&](const Channel& channel, const Message& message, const Leaves& leaves) {
        topics.try_emplace(channel.id, channel).first->second.note(message.logTime, leaves);
    });
    std::size_t variables = 0;
    double bytes = 0;
    for (const auto& [id, topic] : topics) {
        variables += topic.size();
        bytes += topic.bytes();
    }
    if (variables > kMostVariables || bytes > kMostBytes) {
        std::cerr << file->name() << ": error: as NetCDF the messages would be " << variables << " variables with "
                  << bytes << " bytes, of which it may have 65536 with 1e+11; choose topics with --topic\n";
        return kFailed;
    }
    const std::unique_ptr<NewFile> output = NewFile::make(options.output);
    if (!output) return kFailed;
    NetcdfWriter writer(*output);
    FreeNames names;
    for (auto& [id, topic] : topics) topic.define(writer, names, topics.size() == 1);
    std::string error = writer.begin();
    read([&](const Channel& channel, const Message& message, const Leaves& leaves) {
        if (error.empty()) error = topics.at(channel.id).write(writer, message.logTime, leaves);
    });
    if (error.empty()) error = writer.finish();
    if (error.empty()) return file->isDamaged() || decoders.failed() ? kDamaged : kGood;
    std::cerr << options.output << ": error: " << error << "\n";
    std::error_code ignored;
    std::filesystem::remove(options.output, ignored);  // part of such a file is not readable
    return kFailed;
}

}  // namespace oroforge::mcap
