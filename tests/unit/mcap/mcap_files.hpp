// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Recordings in memory, and what a reader finds in them.
#ifndef OROFORGE_TESTS_MCAP_FILES_HPP
#define OROFORGE_TESTS_MCAP_FILES_HPP

#include <reporting/mcap/salvage.hpp>
#include <reporting/mcap/scan.hpp>
#include <reporting/mcap/summary.hpp>
#include <reporting/mcap/writer.hpp>

#include <gmock/gmock.h>

#include <cstring>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace mcap_test {

using namespace oroforge::mcap;

inline std::vector<Compression> compressions() {
    std::vector<Compression> all{Compression::None};
    for (const Compression one : {Compression::Lz4, Compression::Zstd})
        if (hasCompression(one)) all.push_back(one);
    return all;
}

/** A message as a test compares it. */
typedef std::tuple<std::uint16_t, std::uint32_t, std::uint64_t, std::string> Told;

inline Told told(const Message& message) {
    return {message.channel, message.sequence, message.logTime,
            std::string(reinterpret_cast<const char*>(message.data), message.size)};
}

/** Writes a message of that text. False if the chunk is full. */
inline bool addTo(Chunk& chunk, const Told& message) {
    const auto& [channel, sequence, time, text] = message;
    unsigned char* const place = chunk.place(text.size());
    if (!place) return false;
    std::memcpy(place, text.data(), text.size());
    chunk.add({channel, sequence, time, time, nullptr, text.size()});
    return true;
}

/** Of two channels in turn. */
inline std::vector<Told> someMessages(std::uint32_t count) {
    std::vector<Told> all;
    for (std::uint32_t i = 0; i != count; ++i)
        all.emplace_back(static_cast<std::uint16_t>(1 + i % 2), i / 2, 1000 + 10 * i,
                         "message " + std::to_string(i) + std::string(i % 40, 'x'));
    return all;
}

/** A whole file, in chunks of `perChunk` messages. */
struct File {
    explicit File(Compression compression, const std::vector<Told>& messages, std::size_t perChunk = 50) {
        Writer writer(sink);
        EXPECT_TRUE(writer.begin({"ros2", "a test"}));
        EXPECT_TRUE(writer.add(Schema{1, "test/msg/Text", "ros2msg", "string data\n"}));
        EXPECT_TRUE(writer.add(Channel{1, 1, "/a/first", "cdr", {{"unit.x", "m"}}}));
        EXPECT_TRUE(writer.add(Channel{2, 1, "/a/second", "cdr", {}}));
        std::unique_ptr<Compressor> compressor;
        if (compression != Compression::None) compressor.reset(new Compressor(compression));
        PackedChunk packed;
        Chunk chunk(100000);
        std::string why;
        for (std::size_t i = 0; i != messages.size(); ++i) {
            EXPECT_TRUE(addTo(chunk, messages[i]));
            if ((i + 1) % perChunk != 0 && i + 1 != messages.size()) continue;
            EXPECT_TRUE(packed.pack(chunk, compressor.get(), why)) << why;
            chunks.push_back(sink.bytes.size());
            EXPECT_TRUE(writer.write(packed));
            chunk.clear();
        }
        EXPECT_TRUE(writer.add(Metadata{"oroforge", {{"host", "here"}}}));
        dataEnd = sink.bytes.size();
        EXPECT_TRUE(writer.finish());
    }
    Bytes& bytes() { return sink.bytes; }

    MemorySink sink;
    std::vector<std::size_t> chunks;  // where they begin
    std::size_t dataEnd = 0;
};

/** Everything that a scan finds. */
struct Found : Visitor {
    explicit Found(const Bytes& bytes) : Found(bytes, bytes.size()) {}
    Found(const Bytes& bytes, std::size_t size) {
        // A copy of exactly that size, so that AddressSanitizer sees what is read beyond it.
        const std::unique_ptr<unsigned char[]> part(new unsigned char[size]);
        std::copy_n(bytes.begin(), size, part.get());
        MemorySource source(part.get(), size);
        scanned = scan(source, *this);
    }
    void header(const Header& one) override { headers.push_back(one.profile); }
    void schema(const Schema& one) override { schemas.push_back(one); }
    void channel(const Channel& one) override { channels.push_back(one); }
    void message(const Message& one) override { messages.push_back(told(one)); }
    void metadata(const Metadata& one) override { allMetadata.push_back(one); }
    void problem(const Problem& one) override { problems.push_back(one); }

    std::vector<std::string> headers;
    std::vector<Schema> schemas;
    std::vector<Channel> channels;
    std::vector<Told> messages;
    std::vector<Metadata> allMetadata;
    std::vector<Problem> problems;
    Scanned scanned;
};

inline std::vector<std::string> codesOf(const std::vector<Problem>& problems) {
    std::vector<std::string> codes;
    for (const Problem& one : problems) codes.push_back(one.code);
    return codes;
}

}  // namespace mcap_test

#endif
