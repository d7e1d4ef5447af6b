// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_CDR_BYTES_HPP
#define OROFORGE_TESTS_CDR_BYTES_HPP

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace mcap_test {

/** Plain CDR. */
class Cdr {
public:
    std::vector<unsigned char> bytes{0, 1, 0, 0};
    template <class Number>
    Cdr& put(Number number) {
        while ((bytes.size() - 4) % sizeof number != 0) bytes.push_back(0);
        unsigned char raw[sizeof number];
        std::memcpy(raw, &number, sizeof number);
        bytes.insert(bytes.end(), raw, raw + sizeof number);
        return *this;
    }
    Cdr& put(const char* text) { return put(std::string(text)); }
    Cdr& put(const std::string& text) {
        put(static_cast<std::uint32_t>(text.size() + 1));
        bytes.insert(bytes.end(), text.begin(), text.end());
        bytes.push_back(0);
        return *this;
    }
};

}  // namespace mcap_test

#endif
