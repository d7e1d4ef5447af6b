// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/CategoryStream.hpp>

#include <ocl/Category.hpp>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <streambuf>

namespace OCL::logging {

/** What a std::ostream writes to. */
class CategoryStream::Text : public std::streambuf {
public:
    explicit Text(CategoryStream& stream) : stream_(stream) {}

protected:
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        stream_.append(text, static_cast<std::size_t>(size));
        return size;
    }
    int_type overflow(int_type character) override {
        if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
        const char one = traits_type::to_char_type(character);
        stream_.append(&one, 1);
        return character;
    }

private:
    CategoryStream& stream_;
};

CategoryStream::CategoryStream(Category* category, log4cpp::Priority::Value priority) noexcept
    : category_(category), priority_(priority) {}

CategoryStream::~CategoryStream() { flush(); }

void CategoryStream::append(const char* text, std::size_t size) noexcept {
    if (!isOn()) return;
    const std::size_t before = size_;
    size_ += size;
    if (before < kRoom) std::memcpy(text_ + before, text, std::min(size, kRoom - before));
    if (size_ <= kRoom) return;
    try {
        if (before <= kRoom) long_.assign(text_, before);
        if (long_.size() == before) long_.append(text, size);
    } catch (const std::exception&) {
        // No memory: what is there goes to the log with a note.
    }
}

void CategoryStream::flush() noexcept {
    if (size_ == 0 || !isOn()) return;
    if (size_ <= kRoom) {
        category_->log(priority_, text_, size_);
    } else if (long_.size() == size_) {
        category_->log(priority_, long_.data(), size_);
    } else {
        static constexpr char kNote[] = "... (cut: real-time memory is used up)";
        std::memcpy(text_ + kRoom - sizeof kNote + 1, kNote, sizeof kNote - 1);
        category_->log(priority_, text_, kRoom);
    }
    size_ = 0;
    long_.clear();
}

void CategoryStream::appendReal(double value) noexcept {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 6);
    append(digits, static_cast<std::size_t>(end.ptr - digits));
}

void CategoryStream::appendNumber(long long value) noexcept {
    char digits[24];
    append(digits, static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits));
}

void CategoryStream::appendNumber(unsigned long long value) noexcept {
    char digits[24];
    append(digits, static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits));
}

std::ostream& CategoryStream::stream() {
    if (!stream_) {
        buffer_ = std::make_unique<Text>(*this);
        stream_ = std::make_unique<std::ostream>(buffer_.get());
    }
    return *stream_;
}

}  // namespace OCL::logging
