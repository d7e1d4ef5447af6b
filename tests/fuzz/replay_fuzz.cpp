// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any two types are compared, and any bytes become a message of the second one.
#include "fuzzing.hpp"

#include <replay/player/transcoder.hpp>
#include <replay/player/type_difference.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

using namespace oroforge::schema;
using OCL::replay::Transcoder;

namespace {

struct Nothing : PartTaker {
    void beginStruct() override {}
    void field(std::string_view) override {}
    void endStruct() override {}
    void beginList() override {}
    void element(std::size_t) override {}
    void endList() override {}
    void number(std::string_view) override {}
    void text(std::string_view) override {}
};

}  // namespace

/** The input is, twice, the language, the name of the type and the text, then the bytes of defaults, with zero bytes
    between them; then a message. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::uint8_t *at = data, *const end = data + size;
    const auto take = [&] {
        const std::uint8_t* const zero = std::find(at, end, std::uint8_t(0));
        std::string part(at, zero);
        at = zero == end ? end : zero + 1;
        return part;
    };
    MessageSchema types[2];
    std::string why;
    for (MessageSchema& type : types) {
        const std::string language = take(), name = take(), text = take();
        if (!type.read(language, name, text, why)) return 0;
    }
    const auto difference = OCL::replay::compareTypes(types[0], types[1]);
    require(!difference == difference.text().empty(), "a difference has a text");
    // Defaults with zeros, too.
    std::string defaults = take();
    std::replace(defaults.begin(), defaults.end(), '\x01', '\0');
    Transcoder::Defaults all;
    for (const Struct& one : types[1].structs()) all[one.name] = {defaults.begin(), defaults.end()};
    const Transcoder transcoder(types[0], types[1], all);
    std::vector<unsigned char> made;
    const auto count = static_cast<std::size_t>(end - at);
    const bool swaps = size % 2 == 0;
    if (!transcoder.convert(at, count, swaps, made, why)) {
        require(!why.empty(), "an error has a text");
        return 0;
    }
    Nothing parts;
    const unsigned char head[] = {0, 1, 0, 0};
    made.insert(made.begin(), std::begin(head), std::end(head));
    require(types[1].walk(made.data(), made.size(), parts, why), "what is made is a message of the second type", why);
    if (difference || swaps) return 0;
    require(made.size() - sizeof head <= count && count - (made.size() - sizeof head) < 4, "it has the same bytes");
    return 0;
}
