// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any bytes are read as a recording, from the beginning and by their index; what is salvaged of them is whole.
#include "fuzzing.hpp"

#include <reporting/mcap/contents.hpp>
#include <reporting/mcap/in_order.hpp>
#include <reporting/mcap/salvage.hpp>
#include <reporting/mcap/scan.hpp>

#include <cstddef>
#include <cstdint>

using namespace oroforge::mcap;

namespace {

struct Counting : Visitor {
    void message(const Message& message) override {
        ++messages;
        for (std::size_t i = 0; i < message.size; i += 512) sum += message.data[i];
    }
    void problem(const Problem& problem) override {
        require(problem.code != nullptr, "a problem has a code");
        ++problems;
    }
    std::uint64_t messages = 0, problems = 0, sum = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Limits limits;
    limits.largestChunk = std::uint64_t(1) << 24;
    MemorySource source(data, size);
    Counting found;
    const Scanned scanned = scan(source, found, limits);
    require(scanned.whole <= size, "what is whole lies within the file");
    require(scanned.problems == found.problems, "problems are counted");
    Contents contents = readContents(source, [](const Problem&) {});
    Selection selection;
    selection.end = std::uint64_t(1) << 62;
    InOrder messages(
        source, contents.pieces, contents.ids(), selection, [](const Problem&) {}, limits);
    std::uint64_t before = 0;
    while (const Message* const message = messages.next()) {
        // An index may have wrong times.
        require(contents.hasIndex || message->logTime >= before, "messages are in the order of their times");
        before = message->logTime;
    }
    MemorySink sink;
    const Salvaged salvaged = salvage(source, sink);
    require(salvaged.error.empty(), "a file in memory can be written", salvaged.error);
    MemorySource whole(sink.bytes.data(), sink.bytes.size());
    Counting again;
    const Scanned second = scan(whole, again);
    require(second.hasEnd, "what is salvaged has an end");
    require(again.messages >= salvaged.messages, "what is salvaged has all messages");
    return 0;
}
