// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * A row of a report on its way from the component to the thread that writes it: values as in memory, each after a tag
 * with its type. The Fields of the report tell what belongs to which column; sequences have their size in the record.
 */
#ifndef ORO_OCL_REPORTING_RECORD_HPP
#define ORO_OCL_REPORTING_RECORD_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

namespace OCL::reporting {

/** The type of what follows in a record. */
enum class Tag : unsigned char {
    Bag,       ///< nothing; the next values are members
    Sequence,  ///< std::uint32_t: that many elements follow
    Absent,    ///< nothing; a value or group of the report is left out of this row
    Bool,      ///< bool
    Char,      ///< char, printed as a character
    Signed,    ///< std::int64_t
    Unsigned,  ///< std::uint64_t
    Float,     ///< float
    Real,      ///< double
    Text,      ///< std::uint32_t and as many characters
    Other,     ///< const OtherValue* and the bytes of the value
    Fields,    ///< only as the first: const Field*, which the reader then owns, and a row to see its columns
};

/** Encodes records, in one thread. Allocates only if a record is longer than all before. */
class Record {
public:
    Record() { grow(kFirstRoom); }
    /** Makes room for records of that size. */
    void expect(std::size_t size) {
        if (size > static_cast<std::size_t>(end_ - begin_.get())) grow(size);
    }

    void clear() { at_ = begin_.get(); }
    const char* data() const { return begin_.get(); }
    std::size_t size() const { return static_cast<std::size_t>(at_ - begin_.get()); }

    void tag(Tag tag) {
        room(1);
        *at_++ = static_cast<char>(tag);
    }
    template <class T>
    void value(Tag tag, T value) {
        room(1 + sizeof value);
        *at_++ = static_cast<char>(tag);
        std::memcpy(at_, &value, sizeof value);
        at_ += sizeof value;
    }
    void bytes(const void* from, std::size_t count) {
        room(count);
        if (count != 0) std::memcpy(at_, from, count);
        at_ += count;
    }
    void text(Tag tag, std::string_view text) {
        value(tag, static_cast<std::uint32_t>(text.size()));
        bytes(text.data(), text.size());
    }

private:
    static constexpr std::size_t kFirstRoom = 256;

    void room(std::size_t count) {
        if (static_cast<std::size_t>(end_ - at_) < count) grow(size() + count);
    }
    void grow(std::size_t needed) {
        const std::size_t used = begin_ ? size() : 0;
        std::unique_ptr<char[]> larger(new char[2 * needed]);
        if (used != 0) std::memcpy(larger.get(), begin_.get(), used);
        begin_ = std::move(larger);
        at_ = begin_.get() + used;
        end_ = begin_.get() + 2 * needed;
    }

    std::unique_ptr<char[]> begin_;
    char* at_ = nullptr;
    char* end_ = nullptr;
};

/** Decodes a record, in the order in which it was encoded. */
class RecordReader {
public:
    RecordReader(const char* data, std::size_t size) : at_(data), end_(data + size) {}

    bool more() const { return at_ != end_; }
    Tag next() const { return static_cast<Tag>(static_cast<unsigned char>(*at_)); }
    Tag tag() { return static_cast<Tag>(static_cast<unsigned char>(*at_++)); }
    template <class T>
    T value() {
        T result;
        std::memcpy(&result, at_, sizeof result);
        at_ += sizeof result;
        return result;
    }
    const char* bytes(std::size_t count) {
        const char* const result = at_;
        at_ += count;
        return result;
    }
    std::string_view text() {
        const std::size_t size = value<std::uint32_t>();
        return {bytes(size), size};
    }

private:
    const char* at_;
    const char* end_;
};

}  // namespace OCL::reporting

#endif
