// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/execute/code.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

std::size_t Code::add(Action act, const void* a, const void* b, void* to) {
    instructions_.push_back({act, a, {b}, to});
    return instructions_.size() - 1;
}

void Code::beginStatement(ast::Place place) {
    const auto at = static_cast<std::uint32_t>(instructions_.size());
    if (!marks_.empty() && marks_.back().at == at)
        marks_.back().place = place;
    else
        marks_.push_back({at, place});
}

void Code::guard(std::size_t from, std::size_t until, std::size_t handler) {
    guards_.push_back(
        {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(until), static_cast<std::uint32_t>(handler)});
}

void Code::moveLast(std::size_t to) {
    const auto begin = instructions_.begin() + static_cast<std::ptrdiff_t>(to);
    std::rotate(begin, instructions_.end() - 1, instructions_.end());
}

void Code::truncate(std::size_t size) {
    instructions_.resize(size);
    while (!marks_.empty() && marks_.back().at > size) marks_.pop_back();
}

Cell* Code::newCell() {
    cells_.emplace_back();
    return &cells_.back();
}

const Code::Mark* Code::markOf(const Instruction* at) const {
    const auto index = static_cast<std::uint32_t>(at - begin());
    const auto after = std::upper_bound(marks_.begin(), marks_.end(), index,
                                        [](std::uint32_t i, const Mark& mark) { return i < mark.at; });
    return after == marks_.begin() ? nullptr : &*std::prev(after);
}

ast::Place Code::placeOf(const Instruction* at) const {
    const Mark* const mark = markOf(at);
    return mark ? mark->place : ast::Place{};
}

const Instruction* Code::statementOf(const Instruction* at) const {
    const Mark* const mark = markOf(at);
    return mark ? begin() + mark->at : at;
}

bool Code::beginsStatement(const Instruction* at) const {
    const auto index = static_cast<std::uint32_t>(at - begin());
    const auto found = std::lower_bound(marks_.begin(), marks_.end(), index,
                                        [](const Mark& mark, std::uint32_t i) { return mark.at < i; });
    return found != marks_.end() && found->at == index;
}

const Instruction* Code::handlerOf(const Instruction* at) const {
    const auto index = static_cast<std::uint32_t>(at - begin());
    for (const Guard& guard : guards_)
        if (guard.from <= index && index < guard.until) return begin() + guard.handler;
    return nullptr;
}

}  // namespace RTT::scripting::detail
