// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Text that many owners share, as large as a pointer.
#ifndef OROFORGE_DIAG_SHARED_TEXT_HPP
#define OROFORGE_DIAG_SHARED_TEXT_HPP

#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include <boost/smart_ptr/intrusive_ptr.hpp>
#include <boost/smart_ptr/intrusive_ref_counter.hpp>

namespace oroforge::diag {

/// An immutable text that all copies share, in any thread.
class SharedText {
public:
    SharedText() = default;
    SharedText(std::string text) : shared_(new Shared(std::move(text))) {}
    SharedText(const char* text) : SharedText(std::string(text)) {}

    const std::string& str() const;
    operator const std::string&() const { return str(); }
    bool empty() const { return str().empty(); }

    friend bool operator==(const SharedText& a, const SharedText& b) {
        return a.shared_ == b.shared_ || a.str() == b.str();
    }
    friend bool operator!=(const SharedText& a, const SharedText& b) { return !(a == b); }
    friend bool operator<(const SharedText& a, const SharedText& b) {
        return a.shared_ != b.shared_ && a.str() < b.str();
    }

    // Without these, comparing would copy the other text first.
    friend bool operator==(const SharedText& a, const std::string& b) { return a.str() == b; }
    friend bool operator!=(const SharedText& a, const std::string& b) { return a.str() != b; }
    friend bool operator==(const SharedText& a, const char* b) { return a.str() == b; }
    friend bool operator!=(const SharedText& a, const char* b) { return a.str() != b; }

    friend std::string operator+(std::string a, const SharedText& b) { return std::move(a += b.str()); }
    friend std::string operator+(const SharedText& a, std::string_view b) { return std::string(a.str()).append(b); }

    friend std::ostream& operator<<(std::ostream& out, const SharedText& text) { return out << text.str(); }

private:
    struct Shared : boost::intrusive_ref_counter<Shared, boost::thread_safe_counter> {
        explicit Shared(std::string words) : text(std::move(words)) {}
        const std::string text;
    };
    boost::intrusive_ptr<const Shared> shared_;  // null: empty
};

}  // namespace oroforge::diag

#endif
