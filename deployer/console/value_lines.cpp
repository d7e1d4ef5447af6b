// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_lines.hpp"

#include "table.hpp"
#include "value_text.hpp"

#include <rtt/internal/DataSources.hpp>

#include <utility>

namespace OCL::console {
namespace {

typedef RTT::base::DataSourceBase::shared_ptr Source;

constexpr unsigned kDeepest = 8;  // as deep as valueText() shows values

class Lines {
public:
    Lines(bool hex, std::size_t width, std::size_t most) : hex_(hex), width_(width), most_(most) {}

    void addParts(const Source& value, unsigned depth) {
        std::size_t left = 0;
        for (const auto& [name, part] : partsOf(value, left)) add(name, part, depth);
        if (left > 0) put(depth, "… " + std::to_string(left) + " more");
    }

    std::vector<std::string> take() {
        if (count_ > most_ && !lines_.empty())
            lines_.back() = "… " + std::to_string(count_ - most_ + 1) + " more lines";
        return std::move(lines_);
    }

private:
    void put(unsigned depth, const std::string& text) {
        if (++count_ > most_) return;
        const std::string line = std::string(2 * depth, ' ') + text;
        lines_.push_back(shortened(line, width_));
    }

    void add(const std::string& name, const Source& value, unsigned depth) {
        const std::string line = name + " = " + valueOnOneLine(valueText(value, hex_));
        std::size_t left = 0;
        if (2 * depth + widthOf(line) <= width_ || depth >= kDeepest || partsOf(value, left).empty())
            return put(depth, line);
        put(depth, name);
        addParts(value, depth + 1);
    }

    const bool hex_;
    const std::size_t width_, most_;
    std::size_t count_ = 0;  // also of lines that are left out
    std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> valueLines(const Source& value, bool hex, std::size_t width, std::size_t most) {
    Lines lines(hex, width, most);
    lines.addParts(value, 0);
    return lines.take();
}

}  // namespace OCL::console
