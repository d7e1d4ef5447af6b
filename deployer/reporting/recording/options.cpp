// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "options.hpp"

#include <diag/nearest_match.hpp>

#include <utility>
#include <vector>

namespace OCL::recording {
namespace {

using oroforge::diag::didYouMean;
using oroforge::mcap::Compression;
using RTT::encoding::SchemaLanguage;

constexpr unsigned int kSmallestChunk = 1U << 12, kLargestChunk = 1U << 30;
template <class Value>
bool choose(const std::string& property, const std::string& text,
            const std::vector<std::pair<std::string, Value>>& values, Value& value, std::string& why) {
    std::vector<std::string> names;
    std::string list;
    for (const auto& [name, meaning] : values) {
        if (name == text) {
            value = meaning;
            return true;
        }
        names.push_back(name);
        list += (list.empty() ? "" : ", ") + name;
    }
    why = "property " + property + ": found '" + text + "', expected one of " + list + didYouMean(text, names);
    return false;
}

}  // namespace

bool readOptions(const OptionTexts& texts, RecordingOptions& options, std::string& why) {
    std::vector<std::pair<std::string, Compression>> compressions{{"none", Compression::None}};
    for (const Compression one : {Compression::Lz4, Compression::Zstd})
        if (hasCompression(one)) compressions.emplace_back(nameOf(one), one);
    if (!choose("Compression", texts.compression, compressions, options.compression, why) ||
        !choose("Clock", texts.clock, {{"realtime", true}, {"component", false}}, options.realtime, why) ||
        !choose(
            "Schema", texts.schema,
            {{"auto", SchemaLanguage::Auto}, {"ros2msg", SchemaLanguage::Ros2Msg}, {"omgidl", SchemaLanguage::OmgIdl}},
            options.sources.language, why))
        return false;
    if (!readSplit(texts.split, options.split))
        why = "property Split: found '" + texts.split + "', expected a size or a time, such as '500 MB' or '60 s'";
    else if (!readSize(texts.ringSize, options.ringSize))
        why = "property RingSize: found '" + texts.ringSize + "', expected a size, such as '500 MB'";
    else if (texts.chunkSize < kSmallestChunk || texts.chunkSize > kLargestChunk)
        why = "property ChunkSize: found " + std::to_string(texts.chunkSize) + ", expected 4096 to 1073741824 bytes";
    else if (!isTime(texts.chunkTime))
        why = "property ChunkTime: found " + std::to_string(texts.chunkTime) + ", expected seconds, such as 0.5";
    else if (texts.ring != 0 && !isTime(texts.ring))
        why = "property Ring: found " + std::to_string(texts.ring) + ", expected seconds, or 0 to write everything";
    else if (texts.ring != 0 && !texts.split.empty())
        why = "the properties Split and Ring exclude each other: a ring is one file each time that it is saved";
    else if (texts.reproducible && options.realtime)
        why = "the property Reproducible needs Clock=component: the time of day is another one in each run";
    if (!why.empty()) return false;
    options.isReproducible = texts.reproducible;
    options.chunkSize = texts.chunkSize;
    options.chunkTime = texts.chunkTime;
    options.ring = texts.ring;
    return true;
}

}  // namespace OCL::recording
