// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "fields.hpp"

#include "failure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr unsigned kDeepest = 64;  // as deep as values nest
constexpr double kLongest = 3600;

[[noreturn]] void wrong(const char* name, const std::string& found, const char* expected) {
    throw Failure(kMalformed, std::string("field '") + name + "' " + found + ", expected " + expected);
}

/** The number of bytes of the letter that begins there; 0 if that is no UTF-8. */
std::size_t letterAt(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t size = first >= 0xc2 && first < 0xe0 ? 2 : first >= 0xe0 && first < 0xf0 ? 3 : 4;
    if (first < 0xc2 || first > 0xf4) return 0;
    for (std::size_t i = 1; i != size; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    // Overlong forms, halves of UTF-16 and what is beyond Unicode.
    const unsigned second = byte(1);
    if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) || (first == 0xf0 && second < 0x90) ||
        (first == 0xf4 && second > 0x8f))
        return 0;
    return size;
}

void makeTextUtf8(std::string& text) {
    std::string made;
    bool changed = false;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = letterAt(text, at);
        if (size == 0 && !changed) made = text.substr(0, at), changed = true;
        if (size == 0)
            made += "\xef\xbf\xbd";
        else if (changed)
            made.append(text, at, size);
        at += std::max<std::size_t>(size, 1);
    }
    if (changed) text = std::move(made);
}

}  // namespace

bool isTooDeep(const json& value) {
    std::vector<std::pair<const json*, unsigned>> open{{&value, 0}};
    while (!open.empty()) {
        const auto [at, depth] = open.back();
        open.pop_back();
        if (!at->is_structured()) continue;
        if (depth == kDeepest) return true;
        for (const json& inner : *at) open.emplace_back(&inner, depth + 1);
    }
    return false;
}

const char* kindOf(const json& value) {
    switch (value.type()) {
        case json::value_t::null: return "null";
        case json::value_t::object: return "an object";
        case json::value_t::array: return "an array";
        case json::value_t::string: return "a text";
        case json::value_t::boolean: return "a truth value";
        case json::value_t::binary: return "bytes";
        default: return "a number";
    }
}

std::string textField(const json& request, const char* name) {
    const auto field = request.find(name);
    if (field == request.end()) wrong(name, "is missing", "a text");
    if (!field->is_string()) wrong(name, std::string("is ") + kindOf(*field), "a text");
    return field->get<std::string>();
}

std::string textField(const json& request, const char* name, const std::string& otherwise) {
    return request.contains(name) ? textField(request, name) : otherwise;
}

double secondsField(const json& request, const char* name, double otherwise) {
    const char* const expected = "seconds above 0, at most 3600";
    const auto field = request.find(name);
    if (field == request.end()) return otherwise;
    if (!field->is_number()) wrong(name, std::string("is ") + kindOf(*field), expected);
    const double seconds = field->get<double>();
    if (!(seconds > 0 && seconds <= kLongest)) wrong(name, "is " + field->dump(), expected);
    return seconds;
}

std::string cut(const std::string& text, std::size_t most) {
    static const std::string kMore = "…";
    if (text.size() <= most) return text;
    std::size_t end = most > kMore.size() ? most - kMore.size() : 0;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    return text.substr(0, end) + kMore;
}

void makeUtf8(json& value) {
    if (value.is_string()) {
        makeTextUtf8(value.get_ref<std::string&>());
    } else if (value.is_array()) {
        for (json& inner : value) makeUtf8(inner);
    } else if (value.is_object()) {
        json::object_t made;
        for (auto& [name, inner] : value.get_ref<json::object_t&>()) {
            std::string good = name;
            makeTextUtf8(good);
            makeUtf8(inner);
            made.emplace(std::move(good), std::move(inner));
        }
        value = std::move(made);
    }
}

}  // namespace OCL::live
