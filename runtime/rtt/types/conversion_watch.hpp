// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// For code that can show users, better than the log, where a value is converted.
#ifndef OROFORGE_CONVERSION_WATCH_HPP
#define OROFORGE_CONVERSION_WATCH_HPP

#include <rtt/rtt-config.h>

#include <string>
#include <vector>

namespace RTT {
namespace types {
namespace detail {

/** While it exists, conversions in this thread that would log a warning are recorded here instead. */
class RTT_API ConversionWatch {
public:
    struct Conversion {
        std::string from, to;  ///< names of types
    };
    ConversionWatch();
    ~ConversionWatch();
    ConversionWatch(const ConversionWatch&) = delete;
    ConversionWatch& operator=(const ConversionWatch&) = delete;

    const std::vector<Conversion>& conversions() const { return conversions_; }
    /** The innermost watch of this thread, or null. */
    static ConversionWatch* current();
    void note(Conversion conversion) { conversions_.push_back(std::move(conversion)); }

private:
    ConversionWatch* const outer_;
    std::vector<Conversion> conversions_;
};

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
