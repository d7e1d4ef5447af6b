// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "type_difference.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace OCL::replay {
namespace {

using oroforge::schema::Basic;
using oroforge::schema::Field;
using oroforge::schema::Many;
using oroforge::schema::MessageSchema;
using oroforge::schema::Struct;

const char* nameOf(Basic basic) {
    switch (basic) {
        case Basic::Struct: return "struct";
        case Basic::Bool: return "bool";
        case Basic::Int8: return "int8";
        case Basic::UInt8: return "uint8";
        case Basic::Int16: return "int16";
        case Basic::UInt16: return "uint16";
        case Basic::Int32: return "int32";
        case Basic::UInt32: return "uint32";
        case Basic::Int64: return "int64";
        case Basic::UInt64: return "uint64";
        case Basic::Float32: return "float32";
        case Basic::Float64: return "float64";
        case Basic::Text: return "string";
        case Basic::WideText: return "wstring";
    }
    return "";
}

const Field* find(const Struct& in, const std::string& name) {
    const auto found =
        std::find_if(in.fields.begin(), in.fields.end(), [&](const Field& one) { return one.name == name; });
    return found == in.fields.end() ? nullptr : &*found;
}

class Comparison {
public:
    Comparison(const MessageSchema& recorded, const MessageSchema& loaded) : recorded_(recorded), loaded_(loaded) {}

    TypeDifference run() {
        compare(recorded_.root(), loaded_.root(), "");
        const std::vector<Field>& fields = loaded_.root().fields;
        result_.sharesField = std::any_of(fields.begin(), fields.end(), [&](const Field& one) {
            const Field* const was = find(recorded_.root(), one.name);
            return was && isSameKind(*was, one);
        });
        return result_;
    }

private:
    /** The same struct may be at many places: what differs in it is said once. */
    void compare(const Struct& was, const Struct& is, const std::string& path) {
        if (!compared_.insert({&was, &is}).second) return;
        for (const Field& field : is.fields) {
            const Field* const other = find(was, field.name);
            if (!other) {
                add(path + field.name, "is not recorded");
            } else if (!isSameKind(*other, field)) {
                add(path + field.name, "is " + kindOf(field) + ", and was recorded as " + kindOf(*other));
            } else if (other->labels != field.labels || other->isDefault != field.isDefault) {
                add(path + field.name, "has another place among its alternatives");
            } else if (field.basic == Basic::Struct) {
                const std::string inner = path + field.name + (field.lists.empty() ? "." : "[].");
                compareKinds(recorded_.structs()[other->structAt], loaded_.structs()[field.structAt], inner);
            }
        }
        for (const Field& field : was.fields)
            if (!find(is, field.name)) add(path + field.name, "is recorded, but not in the loaded type");
        const bool isOrdered = std::equal(was.fields.begin(), was.fields.end(), is.fields.begin(), is.fields.end(),
                                          [](const Field& a, const Field& b) { return a.name == b.name; });
        if (!isOrdered && result_.fields.empty()) result_.fields.push_back("the fields have another order");
    }

    void compareKinds(const Struct& was, const Struct& is, const std::string& path) {
        if (was.isUnion == is.isUnion && was.discriminator == is.discriminator && was.hasByte == is.hasByte)
            return compare(was, is, path);
        if (was.isUnion || is.isUnion) return add(path.substr(0, path.size() - 1), "has other alternatives");
        compare(was, is, path);
    }

    void add(const std::string& field, const std::string& what) {
        result_.fields.push_back("the field '" + field + "' " + what);
    }

    const MessageSchema& recorded_;
    const MessageSchema& loaded_;
    std::set<std::pair<const Struct*, const Struct*>> compared_;
    TypeDifference result_;
};

}  // namespace

bool isSameKind(const Field& a, const Field& b) {
    return a.basic == b.basic && std::equal(a.lists.begin(), a.lists.end(), b.lists.begin(), b.lists.end(),
                                            [](const Many& one, const Many& other) {
                                                return one.isSequence == other.isSequence && one.count == other.count;
                                            });
}

std::string kindOf(const Field& field) {
    std::string result = field.basic == Basic::Struct ? field.type : nameOf(field.basic);
    for (const Many& many : field.lists) result += many.isSequence ? "[]" : "[" + std::to_string(many.count) + "]";
    return result;
}

std::string TypeDifference::text() const {
    constexpr std::size_t kShown = 3;
    std::string result;
    for (std::size_t i = 0; i != std::min(fields.size(), kShown); ++i) result += (i == 0 ? "" : "; ") + fields[i];
    if (fields.size() > kShown) result += "; and " + std::to_string(fields.size() - kShown) + " more";
    return result;
}

TypeDifference compareTypes(const MessageSchema& recorded, const MessageSchema& loaded) {
    return Comparison(recorded, loaded).run();
}

}  // namespace OCL::replay
