// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/detail/fingerprint.hpp>

#include <cstddef>
#include <map>
#include <string>

namespace RTT::encoding::detail {

namespace {

/** 64-bit FNV-1a over everything that the encoding of a type depends on. */
class Fingerprint {
public:
    void add(const Form& form) {
        // A type that was there before, or contains itself, is named by its place, so each takes one turn.
        const auto [place, isNew] = places_.emplace(&form, places_.size());
        isNew ? addParts(form) : add(kAgain, place->second);
    }
    std::uint64_t value() const { return hash_; }

private:
    static constexpr std::uint64_t kAgain = 255;

    void addParts(const Form& form) {
        add(static_cast<std::uint64_t>(form.shape.kind), form.numberSize);
        if (form.shape.kind == types::Shape::Kind::Number) add(static_cast<std::uint64_t>(form.shape.number), 0);
        for (const types::Shape::Enumerator& one : form.shape.enumerators) {
            add(one.name);
            add(0, static_cast<std::uint64_t>(one.value));
        }
        for (const FormField& field : form.fields) {
            if (form.shape.kind == types::Shape::Kind::Struct && field.isReadOnly()) continue;
            add(field.name);
            add(field.form != nullptr, field.count);
            if (field.form) add(*field.form);
        }
        add(form.hasRows, form.fixedCount);
        if (form.element) add(*form.element);
        if (form.shown) add(*form.shown);
    }
    void add(const std::string& text) {
        for (const char letter : text) addByte(static_cast<unsigned char>(letter));
        addByte(0);
    }
    void add(std::uint64_t a, std::uint64_t b) {
        for (const std::uint64_t number : {a, b})
            for (unsigned shift = 0; shift != 64; shift += 8) addByte(static_cast<unsigned char>(number >> shift));
    }
    void addByte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3U; }

    std::uint64_t hash_ = 0xcbf29ce484222325U;
    std::map<const Form*, std::size_t> places_;
};

}  // namespace

std::uint64_t fingerprintOf(const Form& form) {
    Fingerprint all;
    all.add(form);
    return all.value();
}

}  // namespace RTT::encoding::detail
