// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "check_stamps.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <model/shown_name.hpp>

namespace oroforge::typekit {

namespace {

using model::Field;
using model::Struct;
using model::TypeKind;
using model::TypeUse;

/// As deep as recorders look for a stamp.
constexpr int kDeepest = 8;

bool isOneOf(const std::string& name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

bool isMarked(const Field& field) {
    std::istringstream words(field.doc);
    for (std::string word; words >> word;)
        if (word == "@stamp") return true;
    return false;
}

/// A number or struct that has a place in memory.
bool isPart(const Field& field) { return field.access.isPlace() && field.count == 0; }

bool isLongInteger(const TypeUse& use) {
    return use.kind == TypeKind::Scalar && isOneOf(use.name, {"/int64_t", "/uint64_t", "/llong", "/ullong"});
}

bool isInteger(const TypeUse& use) {
    return isLongInteger(use) ||
           (use.kind == TypeKind::Scalar && isOneOf(use.name, {"/int32_t", "/uint32_t", "/long", "/ulong"}));
}

class StampCheck {
public:
    StampCheck(const model::TypeModel& model, diag::Sink& sink) : sink_(sink) {
        for (const Struct& type : model.structs) structs_[type.name] = &type;
    }

    void check(const Struct& type) {
        const auto first = std::find_if(type.fields.begin(), type.fields.end(),
                                        [&](const Field& field) { return isMarked(field) || hasStamp(field, 1); });
        if (first == type.fields.end() || !isMarked(*first) || canBeTime(*first)) return;
        // Once, although each derived struct has the field, too.
        if (!reported_.insert(first->where.file + ":" + std::to_string(first->where.line) + ":" + first->name).second)
            return;
        sink_
            .warning(first->where, "TK084",
                     "field '" + first->name + "' of '" + model::cppShown(type.cpp) + "' is marked @stamp, but " +
                         whatItIs(*first) + ": recordings do not have its time")
            .hint(
                "a time is an integer of 64 bits, nanoseconds, or a struct with seconds and nanoseconds, such as "
                "'sec' and 'nanosec'");
    }

private:
    const Struct* structOf(const Field& field) const {
        const auto found = structs_.find(field.type.name);
        return field.type.kind != TypeKind::Struct || found == structs_.end() ? nullptr : found->second;
    }

    bool hasStamp(const Field& field, int depth) const {
        const Struct* const inner = isPart(field) && depth != kDeepest ? structOf(field) : nullptr;
        return inner && std::any_of(inner->fields.begin(), inner->fields.end(),
                                    [&](const Field& one) { return isMarked(one) || hasStamp(one, depth + 1); });
    }

    bool canBeTime(const Field& field) const {
        if (!isPart(field)) return false;
        if (field.type.kind != TypeKind::Struct) return isLongInteger(field.type);
        const Struct* const time = structOf(field);
        if (!time) return true;  // that of another package
        bool hasSeconds = false, hasNanoseconds = false;
        for (const Field& one : time->fields) {
            if (!isPart(one) || !isInteger(one.type)) continue;
            hasSeconds = hasSeconds || isOneOf(one.name, {"sec", "secs", "seconds", "tv_sec"});
            hasNanoseconds =
                hasNanoseconds || isOneOf(one.name, {"nanosec", "nsec", "nsecs", "nanoseconds", "tv_nsec"});
        }
        return hasSeconds && hasNanoseconds;
    }

    static std::string whatItIs(const Field& field) {
        if (field.count != 0) return "is an array";
        if (!field.access.isPlace()) return "has no address";
        return "has the type '" + model::cppShown(field.declared) + "'";
    }

    diag::Sink& sink_;
    std::map<std::string, const Struct*> structs_;  // by name
    std::set<std::string> reported_;                // places
};

}  // namespace

void checkStamps(const model::TypeModel& model, diag::Sink& sink) {
    StampCheck stamps(model, sink);
    for (const Struct& type : model.structs) stamps.check(type);
}

}  // namespace oroforge::typekit
