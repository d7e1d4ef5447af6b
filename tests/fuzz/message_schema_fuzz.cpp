// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any text is read as the schema of messages, and any bytes as a message of it.
#include "fuzzing.hpp"

#include <reporting/schema/message_schema.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

using namespace oroforge::schema;

namespace {

struct Parts : PartTaker {
    void beginStruct() override { ++open; }
    void field(std::string_view) override { require(open != 0, "fields are in structs"); }
    void endStruct() override { --open; }
    void beginList() override { ++open; }
    void element(std::size_t) override {
        require(open != 0, "elements are in lists");
        ++elements;
    }
    void endList() override { --open; }
    void number(std::string_view text) override { require(!text.empty(), "a number has a text"); }
    void text(std::string_view) override {}
    std::size_t open = 0, elements = 0;
};

}  // namespace

/** The input is the language, the name of the type, the text, and a message, with zero bytes between them. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::uint8_t *at = data, *const end = data + size;
    const auto take = [&] {
        const std::uint8_t* const zero = std::find(at, end, std::uint8_t(0));
        const std::string part(at, zero);
        at = zero == end ? end : zero + 1;
        return part;
    };
    const std::string encoding = take(), name = take(), text = take();
    MessageSchema schema;
    std::string why;
    if (!schema.read(encoding, name, text, why)) {
        require(!why.empty(), "an error has a text");
        return 0;
    }
    for (const Struct& one : schema.structs())
        for (const Field& field : one.fields)
            require(field.basic != Basic::Struct || field.structAt < schema.structs().size(), "fields have types");
    Parts parts;
    const auto bytes = static_cast<std::size_t>(end - at);
    if (schema.walk(at, bytes, parts, why))
        require(parts.open == 0, "what begins ends");
    else
        require(!why.empty(), "an error has a text");
    require(parts.elements <= 16 * bytes * 100, "lists end with the message");
    return 0;
}
