// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "columns.hpp"

#include <algorithm>
#include <utility>

namespace OCL::reporting {

void Columns::adopt(Field report) {
    used_.clear();
    nodes_.clear();
    report_ = std::move(report);
    for (const Field& field : report_.parts) nodes_.push_back(nodeOf(field, field.name, nullptr));
}

Columns::Node Columns::nodeOf(const Field& field, std::string path, const Node* parent) {
    Node node;
    node.field = &field;
    node.path = std::move(path);
    // What is known of a value is true for its parts, unless they have descriptions of their own.
    node.description = parent && field.description.empty() ? parent->description : &field.description;
    node.unit = parent && field.unit.empty() ? parent->unit : &field.unit;
    if (field.kind == Field::Kind::Group) {
        int number = 0;
        for (const Field& part : field.parts) {
            ++number;
            const std::string name = part.name.empty() ? std::to_string(number) : part.name;
            node.parts.push_back(nodeOf(part, node.path + '.' + name, &node));
        }
    }
    return node;
}

std::size_t Columns::columnOf(std::string name, Column::Role role, const ValueType& type,
                              const std::string& description, const std::string& unit) {
    std::string key = name + '\0' + static_cast<char>('0' + static_cast<int>(role)) +
                      static_cast<char>('0' + static_cast<int>(type.number));
    // Two items of a bag may have one name.
    if (const int before = used_[key]++) key += std::to_string(before);
    const auto [place, isNew] = places_.emplace(std::move(key), all_.size());
    if (isNew) all_.push_back({std::move(name), role, type, description, unit});
    return place->second;
}

std::size_t Columns::countColumn(const Node& node) {
    static const ValueType number{Number::UInt32, nullptr, {}};
    if (!options_.counts) return columnOf(node.path + "[0]", Column::Role::Empty, number, {}, {});
    return columnOf(node.path + ".size", Column::Role::Count, number, "The number of elements of " + node.path + ".",
                    {});
}

void Columns::walk(RecordReader record, ValueTaker& taker) {
    for (Node& node : nodes_)
        if (record.next() == Tag::Absent)
            (void)record.tag();
        else
            walk(node, record, taker);
}

void Columns::walk(Node& node, RecordReader& record, ValueTaker& taker) {
    const Tag tag = record.tag();
    if (node.field->kind == Field::Kind::Value) {
        if (node.column == kNone)
            node.column = columnOf(node.path, Column::Role::Value, node.field->type, *node.description, *node.unit);
        taker.value(node.column, tag, record);
        return;
    }
    taker.bag();
    if (node.field->kind == Field::Kind::Sequence) {
        walkSequence(node, record, taker);
        return;
    }
    for (Node& part : node.parts) walk(part, record, taker);
    if (node.parts.empty()) walkEmpty(node, taker);
}

void Columns::walkSequence(Node& node, RecordReader& record, ValueTaker& taker) {
    const auto count = record.value<std::uint32_t>();
    if (options_.counts && node.field->mayGrow) {
        if (node.count == kNone) node.count = countColumn(node);
        taker.count(node.count, count);
    }
    const Field& element = node.field->parts.front();
    const bool isValue = element.kind == Field::Kind::Value;
    if (options_.elements && isValue && element.type.number < Number::Text) {
        if (node.column == kNone)
            node.column = columnOf(node.path, Column::Role::Elements, element.type, *node.description, *node.unit);
        taker.elements(node.column, count, record);
        return;
    }
    if (count > std::max(node.parts.size(), node.places.size())) addElements(node, count);
    for (std::uint32_t i = 0; i != count; ++i) {
        if (isValue) {
            const Tag tag = record.tag();
            taker.value(node.places[i], tag, record);
        } else {
            walk(node.parts[i], record, taker);
        }
    }
    if (count == 0) walkEmpty(node, taker);
}

void Columns::addElements(Node& node, std::size_t count) {
    const Field& element = node.field->parts.front();
    const std::size_t before = std::max(node.parts.size(), node.places.size());
    // With spare ones, a sequence that grows one by one gives few new layouts.
    const std::size_t all = options_.counts ? std::max(count, 2 * before) : count;
    for (std::size_t i = before; i < all; ++i) {
        std::string path = node.path + '.' + std::to_string(i);
        if (element.kind != Field::Kind::Value)
            node.parts.push_back(nodeOf(element, std::move(path), &node));
        else
            node.places.push_back(
                columnOf(std::move(path), Column::Role::Value, element.type, *node.description, *node.unit));
    }
}

void Columns::walkEmpty(Node& node, ValueTaker& taker) {
    if (options_.counts) return;
    if (node.count == kNone) node.count = countColumn(node);
    taker.count(node.count, 0);
}

}  // namespace OCL::reporting
