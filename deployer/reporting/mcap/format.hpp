// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What records of an MCAP file are, and their numbers and texts as bytes (https://mcap.dev/spec).
#ifndef OROFORGE_MCAP_FORMAT_HPP
#define OROFORGE_MCAP_FORMAT_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace oroforge::mcap {

typedef std::vector<unsigned char> Bytes;
typedef std::map<std::string, std::string> Texts;

/** Both ends of a file. */
constexpr unsigned char kMagic[] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
/** The bytes of a record before its content: what it is and how long. */
constexpr std::size_t kRecordHead = 9;
/** The bytes of a message record before its data, kRecordHead included. */
constexpr std::size_t kMessageHead = kRecordHead + 22;

enum class Op : std::uint8_t {
    Header = 1,
    Footer,
    Schema,
    Channel,
    Message,
    Chunk,
    MessageIndex,
    ChunkIndex,
    Attachment,
    AttachmentIndex,
    Statistics,
    Metadata,
    MetadataIndex,
    SummaryOffset,
    DataEnd
};

/** Numbers are little endian in files, on any machine. */
template <class Number>
void putNumber(unsigned char* to, Number number) {
    for (std::size_t i = 0; i != sizeof number; ++i) to[i] = static_cast<unsigned char>(number >> (8 * i));
}
template <class Number>
Number numberAt(const unsigned char* from) {
    Number number = 0;
    for (std::size_t i = 0; i != sizeof number; ++i)
        number = static_cast<Number>(number | static_cast<Number>(static_cast<Number>(from[i]) << (8 * i)));
    return number;
}

/** Adds a record to bytes; end() sets its length. */
class RecordPut {
public:
    RecordPut(Bytes& out, Op op) : out_(out), begin_(out.size()) {
        out_.push_back(static_cast<unsigned char>(op));
        number<std::uint64_t>(0);
    }

    template <class Number>
    RecordPut& number(Number number) {
        out_.resize(out_.size() + sizeof number);
        putNumber(&out_[out_.size() - sizeof number], number);
        return *this;
    }
    RecordPut& text(std::string_view text) {
        number(static_cast<std::uint32_t>(text.size()));
        out_.insert(out_.end(), text.begin(), text.end());
        return *this;
    }
    RecordPut& texts(const Texts& texts) {
        std::size_t size = 0;
        for (const auto& [name, value] : texts) size += 8 + name.size() + value.size();
        number(static_cast<std::uint32_t>(size));
        for (const auto& [name, value] : texts) text(name).text(value);
        return *this;
    }
    /** The length is that of what was added, and of `more` bytes that follow elsewhere. */
    void end(std::uint64_t more = 0) { putNumber(&out_[begin_ + 1], out_.size() - begin_ - kRecordHead + more); }

private:
    Bytes& out_;
    const std::size_t begin_;
};

/** Takes numbers and texts from bytes, never more than there are. */
class Cursor {
public:
    Cursor(const unsigned char* begin, std::size_t size) : begin_(begin), at_(begin), end_(begin + size) {}

    /** False if something was larger than the bytes that were left; what was taken since then is 0 or empty. */
    bool good() const { return good_; }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    std::size_t position() const { return static_cast<std::size_t>(at_ - begin_); }

    template <class Number>
    Number number() {
        const unsigned char* const from = take(sizeof(Number));
        return from ? numberAt<Number>(from) : Number(0);
    }
    std::string_view text() {
        const auto size = number<std::uint32_t>();
        const unsigned char* const from = take(size);
        return from ? std::string_view(reinterpret_cast<const char*>(from), size) : std::string_view();
    }
    Texts texts() {
        Texts result;
        Cursor all = part(number<std::uint32_t>());
        while (all.good() && all.left() != 0) {
            const std::string_view name = all.text();
            result.emplace(name, all.text());
        }
        good_ = good_ && all.good();
        return result;
    }
    /** The next bytes as a cursor of their own. */
    Cursor part(std::uint64_t size) {
        const unsigned char* const from = take(size);
        return from ? Cursor(from, static_cast<std::size_t>(size)) : Cursor(at_, 0);
    }
    /** Null if there are not so many. */
    const unsigned char* take(std::uint64_t size) {
        if (!good_ || size > left()) {
            good_ = false;
            return nullptr;
        }
        return (at_ += size) - size;
    }

private:
    const unsigned char* begin_;
    const unsigned char* at_;
    const unsigned char* end_;
    bool good_ = true;
};

}  // namespace oroforge::mcap

#endif
