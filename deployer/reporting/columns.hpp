// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_COLUMNS_HPP
#define ORO_OCL_REPORTING_COLUMNS_HPP

#include "fields.hpp"
#include "record.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace OCL::reporting {

struct Column {
    enum class Role {
        Value,
        Elements,  ///< all elements of a sequence of numbers
        Count,     ///< the number of elements of a sequence
        Empty      ///< a group or sequence without parts
    };
    std::string name;  ///< "Component.port.member"
    Role role = Role::Value;
    ValueType type;
    std::string description, unit;
};

/** Gets the values of a row in the order of the record. */
class ValueTaker {
public:
    virtual ~ValueTaker() = default;
    /** A value with members or elements begins. */
    virtual void bag() {}
    /** Must read the value, which `tag` precedes. */
    virtual void value(std::size_t column, Tag tag, RecordReader& record) = 0;
    /** Must read as many values with their tags. */
    virtual void elements(std::size_t, std::uint32_t, RecordReader&) {}
    virtual void count(std::size_t column, std::uint32_t count) = 0;
};

/**
 * The columns of a report. One that was there once keeps its place for good: what comes later, as the new elements of a
 * sequence, has its columns behind all others.
 */
class Columns {
public:
    struct Options {
        /** Sequences that may grow have a column Count, instead of Empty when they are empty, and spare columns. */
        bool counts = false;
        bool elements = false;  ///< sequences of numbers have one column
    };
    explicit Columns(Options options) : options_(options) {}

    /** Sets what the records consist of from now on. Columns of the same name and type are found again. */
    void adopt(Field report);
    /** Passes the values of a row on, and adds columns that it has for the first time. */
    void walk(RecordReader record, ValueTaker& taker);

    const std::vector<Column>& all() const { return all_; }

private:
    static constexpr std::size_t kNone = ~std::size_t(0);
    struct Node {
        const Field* field = nullptr;
        std::string path;
        const std::string* description = nullptr;
        const std::string* unit = nullptr;
        std::size_t column = kNone;  // of the value, or of all elements
        std::size_t count = kNone;   // of the count or emptiness
        std::vector<Node> parts;
        std::vector<std::size_t> places;  // instead of parts, if the elements are values: their columns
    };

    Node nodeOf(const Field& field, std::string path, const Node* parent);
    std::size_t columnOf(std::string name, Column::Role role, const ValueType& type, const std::string& description,
                         const std::string& unit);
    std::size_t countColumn(const Node& node);
    void addElements(Node& node, std::size_t count);
    void walk(Node& node, RecordReader& record, ValueTaker& taker);
    void walkSequence(Node& node, RecordReader& record, ValueTaker& taker);
    void walkEmpty(Node& node, ValueTaker& taker);

    const Options options_;
    std::vector<Column> all_;
    std::unordered_map<std::string, std::size_t> places_;
    std::unordered_map<std::string, int> used_;  // how many columns of the present fields have that name and type
    std::vector<Node> nodes_;
    Field report_;
};

}  // namespace OCL::reporting

#endif
