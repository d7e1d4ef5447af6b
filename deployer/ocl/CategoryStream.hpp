// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_CATEGORY_STREAM_HPP
#define ORO_OCL_CATEGORY_STREAM_HPP

#include <log4cpp/CategoryStream.hh>
#include <log4cpp/Priority.hh>
#include <ocl/OCL.hpp>
#include <rtt/rt_string.hpp>
#include <rtt/rtt-config.h>

#include <cstddef>
#include <ios>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace OCL {
namespace logging {

class Category;

/**
 * Composes one message, which goes to the category at flush() or the end of the stream. For one thread.
 *
 * Texts, characters and numbers are written without allocation or lock as long as the message has at most kRoom
 * characters; after that it is in real-time memory, and where that is used up, the rest is left out and the message
 * says so. Manipulators of std::ostream, and types with an operator<< for it, make such a stream, which allocates.
 */
class OCL_API CategoryStream {
public:
    static constexpr std::size_t kRoom = 512;

    /** With the priority NOTSET, all that is written is ignored. */
    CategoryStream(Category* category, log4cpp::Priority::Value priority) noexcept;
    ~CategoryStream();
    CategoryStream(const CategoryStream&) = delete;
    CategoryStream& operator=(const CategoryStream&) = delete;

    /** Logs what was written since the last flush(), if anything was. */
    void flush() noexcept;
    log4cpp::Priority::Value getPriority() const noexcept { return priority_; }

    template <class T>
    CategoryStream& operator<<(const T& value) {
        if (!isOn()) return *this;
        // log4cpp::eol. Not an operator of its own, which would make `eol` ambiguous where both namespaces are used.
        if constexpr (std::is_same_v<T, log4cpp::CategoryStream&(log4cpp::CategoryStream&)>) {
            flush();
        } else if constexpr (std::is_convertible_v<const T&, std::string_view> || std::is_same_v<T, char>) {
            if (stream_)
                *stream_ << value;
            else if constexpr (std::is_same_v<T, char>)
                append(&value, 1);
            else
                appendText(value);
        } else if constexpr (std::is_same_v<T, RTT::rt_string>) {
            const std::string_view text(value.data(), value.size());
            stream_ ? void(*stream_ << text) : append(text.data(), text.size());
        } else if constexpr (std::is_floating_point_v<T>) {
            stream_ ? void(*stream_ << value) : appendReal(static_cast<double>(value));
        } else if constexpr (isNumber<T>) {
            if (stream_)
                *stream_ << value;
            else if constexpr (std::is_signed_v<T>)
                appendNumber(static_cast<long long>(value));
            else
                appendNumber(static_cast<unsigned long long>(value));
        } else {
            stream() << value;
        }
        return *this;
    }
    /** flush and eol of this namespace. */
    CategoryStream& operator<<(CategoryStream& (*change)(CategoryStream&)) { return change(*this); }
    /** std::hex and the like. Allocates. */
    CategoryStream& operator<<(std::ios_base& (*change)(std::ios_base&)) {
        if (isOn()) change(stream());
        return *this;
    }
    /** std::endl, which ends the message here. */
    CategoryStream& operator<<(std::ostream& (*)(std::ostream&)) {
        flush();
        return *this;
    }

private:
    class Text;
    // Not character types of other widths, which std::ostream refuses.
    template <class T>
    static constexpr bool isNumber =
        std::is_integral_v<T> && !std::is_same_v<T, signed char> && !std::is_same_v<T, unsigned char> &&
        !std::is_same_v<T, wchar_t> && !std::is_same_v<T, char16_t> && !std::is_same_v<T, char32_t>;
    bool isOn() const noexcept { return priority_ != log4cpp::Priority::NOTSET; }
    void appendText(std::string_view text) noexcept { append(text.data(), text.size()); }
    void appendText(const char* text) noexcept {
        if (text) append(text, std::char_traits<char>::length(text));
    }
    void append(const char* text, std::size_t size) noexcept;
    void appendReal(double value) noexcept;
    void appendNumber(long long value) noexcept;
    void appendNumber(unsigned long long value) noexcept;
    std::ostream& stream();

    Category* const category_;
    const log4cpp::Priority::Value priority_;
    std::size_t size_ = 0;  // of all that was written
    RTT::rt_string long_;   // all of it, if it does not fit into text_
    std::unique_ptr<Text> buffer_;
    std::unique_ptr<std::ostream> stream_;
    char text_[kRoom];
};

/** Both log what was written so far. */
inline CategoryStream& flush(CategoryStream& stream) {
    stream.flush();
    return stream;
}
inline CategoryStream& eol(CategoryStream& stream) { return flush(stream); }

}  // namespace logging
}  // namespace OCL

#endif
