// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/Schema.hpp>

#include <cstring>
#include <set>
#include <utility>

namespace RTT::types {

namespace {

bool same(const char* a, const char* b) { return std::strcmp(a, b) == 0; }

const SchemaField* find(const Schema& schema, const char* name) {
    for (std::size_t i = 0; i < schema.count; ++i)
        if (same(schema.fields[i].name, name)) return &schema.fields[i];
    return nullptr;
}

/** "byte 8", "bit 67". */
std::string placeText(long long bits) {
    return bits % 8 == 0 ? "byte " + std::to_string(bits / 8) : "bit " + std::to_string(bits);
}

std::string quoted(const std::string& path, const char* name) {
    const bool index = same(name, "[]");
    return "field '" + path + (path.empty() || index ? "" : ".") + name + "'";
}

class Comparison {
public:
    Comparison(const std::string& here, const std::string& there) : here_(here), there_(there) {}

    std::string compare(const Schema& a, const Schema& b, const std::string& path) {
        if (&a == &b || !met_.insert({&a, &b}).second) return "";
        std::string text;
        if (a.isEnum && b.isEnum)
            text = compareEnumerators(a, b, path);
        else if (bool(*a.name) == bool(*b.name))
            text = compareFields(a, b, path);
        if (!text.empty()) return text;
        if (a.size != b.size) return bytes("has", a.size, b.size, " bytes", path);
        return a.align == b.align ? "" : bytes("is aligned to", a.align, b.align, " bytes", path);
    }

private:
    std::string both(const std::string& what, const std::string& inA, const std::string& inB) const {
        return what + " " + inA + " " + here_ + ", " + inB + " " + there_;
    }
    std::string bytes(const char* verb, std::size_t a, std::size_t b, const char* unit, const std::string& path) const {
        const std::string subject = path.empty() ? "the type" : "field '" + path + "'";
        return both(subject + " " + verb, std::to_string(a) + unit, std::to_string(b) + unit);
    }

    std::string compareEnumerators(const Schema& a, const Schema& b, const std::string& path) const {
        const std::string where = path.empty() ? "" : "of field '" + path + "' ";
        for (std::size_t i = 0; i < a.count; ++i) {
            const SchemaField& one = a.fields[i];
            const SchemaField* const other = find(b, one.name);
            const std::string what = "enumerator '" + std::string(one.name) + "' " + where;
            if (other && other->place != one.place)
                return both(what + "is", std::to_string(one.place), std::to_string(other->place));
            if (other) continue;
            // Enumerators may be added and removed, but a number must not change its meaning.
            for (std::size_t k = 0; k < b.count; ++k)
                if (b.fields[k].place == one.place && !find(a, b.fields[k].name))
                    return both(what + "(" + std::to_string(one.place) + ") is called",
                                "'" + std::string(one.name) + "'", "'" + std::string(b.fields[k].name) + "'");
        }
        return "";
    }

    std::string compareFields(const Schema& a, const Schema& b, const std::string& path) {
        for (std::size_t i = 0; i < a.count && i < b.count; ++i) {
            const SchemaField& one = a.fields[i];
            const SchemaField& other = b.fields[i];
            std::string text =
                same(one.name, other.name) ? compareField(one, other, path) : compareNames(a, b, i, path);
            if (!text.empty()) return text;
        }
        if (a.count == b.count) return "";
        const SchemaField& extra = a.count > b.count ? a.fields[b.count] : b.fields[a.count];
        return onlyIn(a.count > b.count, extra.name, path);
    }

    std::string onlyIn(bool isHere, const char* name, const std::string& path) const {
        return quoted(path, name) + " is there only " + (isHere ? here_ : there_);
    }

    std::string compareNames(const Schema& a, const Schema& b, std::size_t i, const std::string& path) const {
        const char* const one = a.fields[i].name;
        const char* const other = b.fields[i].name;
        const SchemaField* const moved = find(b, one);
        if (!moved && !find(a, other) && a.fields[i].place == b.fields[i].place)
            return both(quoted(path, one) + " is called", "'" + std::string(one) + "'", "'" + std::string(other) + "'");
        if (!moved) return onlyIn(true, one, path);
        if (!find(a, other)) return onlyIn(false, other, path);
        return both(quoted(path, one) + " is at", placeText(a.fields[i].place), placeText(moved->place));
    }

    std::string compareField(const SchemaField& a, const SchemaField& b, const std::string& path) {
        if (!same(a.type, b.type))
            return both(quoted(path, a.name) + " is of type", "'" + std::string(a.type) + "'",
                        "'" + std::string(b.type) + "'");
        if (a.place != b.place) return both(quoted(path, a.name) + " is at", placeText(a.place), placeText(b.place));
        if (*a.unit && *b.unit && !same(a.unit, b.unit))
            return both(quoted(path, a.name) + " has the unit", a.unit, b.unit);
        if (!a.of || !b.of) return "";
        const bool index = same(a.name, "[]");
        return compare(a.of(), b.of(), path + (path.empty() || index ? "" : ".") + a.name);
    }

    const std::string& here_;
    const std::string& there_;
    std::set<std::pair<const Schema*, const Schema*>> met_;  // types may contain themselves in containers
};

/** FNV-1a, which needs no seed and is the same everywhere. */
class Hash {
public:
    void add(const char* text) {
        do byte(static_cast<unsigned char>(*text));
        while (*text++);
    }
    void add(std::uint64_t number) {
        for (int i = 0; i < 8; ++i) byte(static_cast<unsigned char>(number >> (8 * i)));
    }
    std::uint64_t value() const { return value_; }

private:
    void byte(unsigned char byte) { value_ = (value_ ^ byte) * 1099511628211u; }
    std::uint64_t value_ = 14695981039346656037u;
};

enum class Of { Layout, Names };

void addTo(Hash& hash, const Schema& schema, Of what, std::set<const Schema*>& met) {
    if (!met.insert(&schema).second) return;
    if (what == Of::Layout) {
        hash.add(schema.size);
        hash.add(schema.align);
        if (schema.isEnum) return;
    } else {
        hash.add(schema.name);
    }
    hash.add(schema.count);
    for (std::size_t i = 0; i < schema.count; ++i) {
        const SchemaField& field = schema.fields[i];
        if (what == Of::Layout || schema.isEnum) hash.add(static_cast<std::uint64_t>(field.place));
        if (what == Of::Names) {
            hash.add(field.name);
            hash.add(field.type);
        }
        if (field.of) addTo(hash, field.of(), what, met);
    }
}

std::uint64_t hashOf(const Schema& schema, Of what) {
    Hash hash;
    std::set<const Schema*> met;
    addTo(hash, schema, what, met);
    return hash.value();
}

}  // namespace

std::string schemaDifference(const Schema& a, const Schema& b, const std::string& here, const std::string& there) {
    return Comparison(here, there).compare(a, b, "");
}

std::uint64_t layoutHash(const Schema& schema) { return hashOf(schema, Of::Layout); }

std::uint64_t schemaHash(const Schema& schema) { return hashOf(schema, Of::Names); }

}  // namespace RTT::types
