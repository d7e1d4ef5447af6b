// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diff/compare_models.hpp>

#include <algorithm>
#include <map>
#include <sstream>

#include <plan/cpp_words.hpp>

namespace oroforge::typekit {

namespace {

using model::Adapted;
using model::Enum;
using model::Enumerator;
using model::Field;
using model::Struct;

/// Returns "byte 8" or "bit 67".
std::string placeText(std::uint64_t bits) {
    return bits % 8 == 0 ? "byte " + std::to_string(bits / 8) : "bit " + std::to_string(bits);
}

std::string typeText(const Field& field) {
    const std::string type = cppShown(field.declared.empty() ? field.type.cpp : field.declared);
    return field.width == 0 ? type : type + " : " + std::to_string(field.width);
}

/// Returns "3" or "2 x 3"; "any number of" for a size that may change.
std::string shapeText(const Adapted& type) {
    const auto number = [](const std::string& cpp) {
        return cpp.find_first_not_of("0123456789") == std::string::npos ? cpp : "any number of";
    };
    return type.columns.empty() ? number(type.count) : number(type.count) + " x " + number(type.columns);
}

std::string nowAndThen(const std::string& now, const std::string& then) { return now + ", was " + then; }

template <class Item>
const Item* find(const std::vector<Item>& items, const std::string& name) {
    const auto at = std::find_if(items.begin(), items.end(), [&name](const Item& item) { return item.name == name; });
    return at == items.end() ? nullptr : &*at;
}

class Comparison {
public:
    std::vector<Change> changes;

    void compare(const Struct& old, const Struct& now) {
        const std::size_t before = changes.size();
        for (const Field& field : now.fields) {
            if (const Field* const same = find(old.fields, field.name)) {
                compare(*same, field, now);
            } else if (const Field* const other = calledBefore(field, old, now)) {
                add(true, nameOf(field, now) + " was called '" + other->name + "'", field.where, other->where);
            } else {
                add(true, nameOf(field, now) + " is new", field.where, old.where);
            }
        }
        for (const Field& field : old.fields) {
            if (!find(now.fields, field.name) && !calledNow(field, old, now))
                add(true, nameOf(field, old) + " is gone", field.where, {});
        }
        compareMessages(old, now);
        const std::string subject = "'" + cppShown(now.cpp) + "'";
        if (old.assignable && !now.assignable) add(true, subject + " can no longer be assigned", now.where, old.where);
        // Any other difference already explains a new size.
        if (changes.size() == before) compareSizes(old, now);
    }

    void compare(const Adapted& old, const Adapted& now) {
        const std::size_t before = changes.size();
        const std::string subject = "'" + cppShown(now.cpp) + "'";
        if (old.element.cpp != now.element.cpp)
            add(true,
                "an element of " + subject + " is of type " +
                    nowAndThen("'" + cppShown(now.element.cpp) + "'", "'" + cppShown(old.element.cpp) + "'"),
                now.where, old.where);
        if (old.columns.empty() != now.columns.empty())
            add(true,
                subject + " is " + (now.columns.empty() ? "a sequence, was a matrix" : "a matrix, was a sequence"),
                now.where, old.where);
        if (shapeText(old) != shapeText(now))
            add(true, subject + " has " + nowAndThen(shapeText(now) + " elements", shapeText(old)), now.where,
                old.where);
        if (changes.size() == before) compareSizes(old, now);
    }

    void compare(const Enum& old, const Enum& now) {
        const std::string subject = " of '" + cppShown(now.cpp) + "' ";
        for (const Enumerator& value : now.values) {
            const Enumerator* const same = find(old.values, value.name);
            if (same && same->value != value.value)
                add(true, "enumerator '" + value.name + "'" + subject + "is " + nowAndThen(value.value, same->value),
                    value.where, same->where);
            if (!same) add(false, "enumerator '" + value.name + "'" + subject + "is new", value.where, old.where);
        }
        for (const Enumerator& value : old.values)
            if (!find(now.values, value.name))
                add(true, "enumerator '" + value.name + "'" + subject + "is gone", value.where, {});
        if (old.underlying != now.underlying)
            add(true, "'" + cppShown(now.cpp) + "' is " + nowAndThen(now.underlying, old.underlying), now.where,
                old.where);
    }

    /// Compares all types of one kind, by their C++ names.
    template <class Type>
    void compareAll(const std::vector<Type>& old, const std::vector<Type>& now, const char* kind) {
        std::map<std::string, const Type*> before;
        for (const Type& type : old) before.emplace(type.cpp, &type);
        for (const Type& type : now) {
            const auto same = before.find(type.cpp);
            if (same == before.end()) {
                add(false, std::string(kind) + " '" + cppShown(type.cpp) + "' is new", type.where, {});
                continue;
            }
            compare(*same->second, type);
            before.erase(same);
        }
        for (const auto& [name, type] : before)
            add(true, std::string(kind) + " '" + cppShown(name) + "' is gone", type->where, {});
    }

private:
    /// The messages of ROS that `@ros` names. A port publishes another topic type if they differ.
    void compareMessages(const Struct& old, const Struct& now) {
        std::istringstream oldWords(old.message), nowWords(now.message);
        std::string was, is, oldSum, nowSum;
        oldWords >> was >> oldSum;
        nowWords >> is >> nowSum;
        const std::string subject = "'" + cppShown(now.cpp) + "' is ";
        if (was != is)
            add(!was.empty(),
                subject +
                    nowAndThen(is.empty() ? "no message of ROS" : "the message " + is, was.empty() ? "none" : was),
                now.where, old.where);
        else if (oldSum != nowSum && !oldSum.empty() && !nowSum.empty())
            add(true, subject + "the message " + is + " with MD5 sum " + nowAndThen(nowSum, oldSum), now.where,
                old.where);
    }

    template <class Type>
    void compareSizes(const Type& old, const Type& now) {
        const std::string subject = "'" + cppShown(now.cpp) + "'";
        if (old.size != now.size)
            add(true, subject + " has " + nowAndThen(std::to_string(now.size) + " bytes", std::to_string(old.size)),
                now.where, old.where);
        else if (old.align != now.align)
            add(true,
                subject + " is aligned to " +
                    nowAndThen(std::to_string(now.align) + " bytes", std::to_string(old.align)),
                now.where, old.where);
    }

    static std::string nameOf(const Field& field, const Struct& type) {
        return "field '" + field.name + "' of '" + cppShown(type.cpp) + "'";
    }

    void add(bool breaking, std::string message, const diag::Location& where, const diag::Location& was) {
        changes.push_back({breaking, std::move(message), where, was});
    }

    /// Finds the old field at the same place whose name is gone: `field` is that field renamed.
    static const Field* calledBefore(const Field& field, const Struct& old, const Struct& now) {
        for (const Field& other : old.fields)
            if (other.place == field.place && typeText(other) == typeText(field) && !find(now.fields, other.name))
                return &other;
        return nullptr;
    }
    static bool calledNow(const Field& field, const Struct& old, const Struct& now) {
        return std::any_of(now.fields.begin(), now.fields.end(), [&](const Field& other) {
            return !find(old.fields, other.name) && calledBefore(other, old, now) == &field;
        });
    }

    void compare(const Field& old, const Field& now, const Struct& type) {
        const std::string subject = nameOf(now, type);
        const auto tell = [&](bool breaking, const std::string& what) {
            add(breaking, subject + " " + what, now.where, old.where);
        };
        if (typeText(old) != typeText(now))
            tell(true, "is of type " + nowAndThen("'" + typeText(now) + "'", "'" + typeText(old) + "'"));
        else if (old.place != now.place)
            tell(true, "is at " + nowAndThen(placeText(now.place), "at " + placeText(old.place)));
        const bool wasWritable = !old.access.isConstant(), isWritable = !now.access.isConstant();
        if (wasWritable && !isWritable) tell(true, "can no longer be written");
        if (!wasWritable && isWritable) tell(false, "can be written now");
        if (old.unit != now.unit)
            tell(!old.unit.empty() && !now.unit.empty(),
                 "has " + nowAndThen(now.unit.empty() ? "no unit" : "the unit " + now.unit,
                                     old.unit.empty() ? "none" : old.unit));
        if (old.range != now.range)
            tell(false, "has " + nowAndThen(now.range.empty() ? "no range" : "the range " + now.range,
                                            old.range.empty() ? "none" : old.range));
        if (old.initial != now.initial)
            tell(false, "begins as " + nowAndThen(now.initial.empty() ? "nothing" : now.initial,
                                                  old.initial.empty() ? "nothing" : old.initial));
    }
};

}  // namespace

std::vector<Change> compareModels(const model::TypeModel& old, const model::TypeModel& now) {
    Comparison comparison;
    comparison.compareAll(old.structs, now.structs, "struct");
    comparison.compareAll(old.adapted, now.adapted, "class");
    comparison.compareAll(old.enums, now.enums, "enum");
    return comparison.changes;
}

}  // namespace oroforge::typekit
