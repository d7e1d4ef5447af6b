// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Plain CDR, part by part, without its head.
#ifndef OROFORGE_REPLAY_CDR_PARTS_HPP
#define OROFORGE_REPLAY_CDR_PARTS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace OCL::replay {

/** Reads parts, never more than there are. Its functions return false if there are not so many bytes. */
class CdrReader {
public:
    CdrReader(const unsigned char* data, std::size_t size, bool swaps) : data_(data), size_(size), swaps_(swaps) {}

    std::size_t at() const { return at_; }
    std::size_t left() const { return size_ - at_; }
    void moveTo(std::size_t at) { at_ = at; }

    bool align(std::size_t to) {
        const std::size_t begin = (at_ + to - 1) / to * to;
        if (begin > size_) return fail("the message ends within a field");
        at_ = begin;
        return true;
    }
    /** Numbers of one size. Without `to` they are passed over. */
    bool numbers(std::size_t count, std::size_t size, unsigned char* to = nullptr) {
        if (count == 0) return true;
        if (!align(size)) return false;
        if (left() / size < count) return fail("the message ends within a field");
        if (to) {
            std::memcpy(to, data_ + at_, count * size);
            for (std::size_t i = 0; swaps_ && size > 1 && i != count; ++i)
                std::reverse(to + i * size, to + (i + 1) * size);
        }
        at_ += count * size;
        return true;
    }
    bool count(std::uint32_t& count) {
        unsigned char bytes[sizeof count] = {};
        if (!numbers(1, sizeof count, bytes)) return false;
        std::memcpy(&count, bytes, sizeof count);
        // Each element, and each letter, has a byte at least.
        return count <= left() || fail("a length of " + std::to_string(count) + " is larger than the rest");
    }

    /** Always false. The first problem counts. */
    bool fail(const std::string& problem) {
        if (problem_.empty()) problem_ = "byte " + std::to_string(at_) + ": " + problem;
        return false;
    }
    const std::string& problem() const { return problem_; }

private:
    const unsigned char* const data_;
    const std::size_t size_;
    const bool swaps_;
    std::size_t at_ = 0;
    std::string problem_;
};

/** Adds parts in the byte order of this machine. */
class CdrWriter {
public:
    explicit CdrWriter(std::vector<unsigned char>& out) : out_(out) {}

    std::size_t size() const { return out_.size(); }
    /** Where so many numbers are to be written. */
    unsigned char* numbers(std::size_t count, std::size_t size) {
        if (count == 0) return nullptr;
        const std::size_t begin = (out_.size() + size - 1) / size * size;
        out_.resize(begin + count * size);
        return &out_[begin];
    }
    void count(std::uint32_t count) { std::memcpy(numbers(1, sizeof count), &count, sizeof count); }

private:
    std::vector<unsigned char>& out_;
};

}  // namespace OCL::replay

#endif
