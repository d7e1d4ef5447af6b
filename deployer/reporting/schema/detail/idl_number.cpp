// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Numbers wrap around as unsigned ones do; so no text makes them overflow.
#include "idl_number.hpp"

#include "limits.hpp"

#include <charconv>
#include <iterator>
#include <system_error>

namespace oroforge::schema {
namespace {

class Expression {
public:
    Expression(IdlReader& reader, const IdlNames& names, const std::string& scope)
        : reader_(reader), names_(names), scope_(scope) {}

    bool read(std::int64_t& number, bool isWithinAngles) {
        std::uint64_t bits = 0;
        if (!binary(bits, isWithinAngles ? kShifts + 1 : 0)) return false;
        number = static_cast<std::int64_t>(bits);
        return true;
    }

private:
    /** Operators by how weakly they bind. */
    static constexpr std::string_view kLevels[] = {"|", "^", "&", "<>", "+-", "*/%"};
    static constexpr std::size_t kShifts = 3;

    bool isOperator(std::size_t level) const {
        const std::string_view text = reader_.next().text;
        if (reader_.next().kind != IdlToken::Sign) return false;
        if (level == kShifts) return reader_.isPair('<') || reader_.isPair('>');
        return kLevels[level].find(text) != std::string_view::npos;
    }

    bool binary(std::uint64_t& value, std::size_t level) {
        if (level == std::size(kLevels)) return unary(value);
        if (!binary(value, level + 1)) return false;
        while (isOperator(level)) {
            const IdlToken sign = reader_.take();
            if (level == kShifts) reader_.take();
            std::uint64_t other = 0;
            if (!binary(other, level + 1) || !apply(sign, value, other)) return false;
        }
        return true;
    }

    bool apply(const IdlToken& sign, std::uint64_t& value, std::uint64_t other) {
        const auto left = static_cast<std::int64_t>(value), right = static_cast<std::int64_t>(other);
        switch (sign.text.front()) {
            case '|': value |= other; break;
            case '^': value ^= other; break;
            case '&': value &= other; break;
            case '<': value = other < 64 ? value << other : 0; break;
            case '>': value = other < 64 ? value >> other : 0; break;
            case '+': value += other; break;
            case '-': value -= other; break;
            case '*': value *= other; break;
            default:
                if (right == 0) return reader_.fail(sign.line, "a number is divided by 0");
                // Of the smallest number it would overflow.
                if (right == -1)
                    value = sign.text == "/" ? 0 - value : 0;
                else
                    value = static_cast<std::uint64_t>(sign.text == "/" ? left / right : left % right);
        }
        return true;
    }

    bool unary(std::uint64_t& value) {
        const Deeper deeper(depth_);
        if (depth_ > kDeepest) return reader_.fail("parentheses nest too deeply");
        if (reader_.accept("-")) {
            if (!unary(value)) return false;
            value = 0 - value;
            return true;
        }
        if (reader_.accept("~")) {
            if (!unary(value)) return false;
            value = ~value;
            return true;
        }
        if (reader_.accept("+")) return unary(value);
        if (reader_.accept("(")) return binary(value, 0) && reader_.expect(")");
        return literal(value);
    }

    bool literal(std::uint64_t& value) {
        const IdlToken& token = reader_.next();
        if (token.kind == IdlToken::Number) {
            if (!parse(token.text, value)) return reader_.failAt("an integer");
        } else if (token.kind == IdlToken::Character && token.text.size() == 3) {
            value = static_cast<unsigned char>(token.text[1]);
        } else if (token.text == "TRUE" || token.text == "FALSE") {
            value = token.text == "TRUE" ? 1 : 0;
        } else if (token.kind == IdlToken::Name) {
            const auto found = findName(names_.constants, scope_, token.text);
            if (found == names_.constants.end())
                return reader_.failAt("an integer, or a constant that is described before");
            value = static_cast<std::uint64_t>(found->second);
        } else {
            return reader_.failAt("an integer");
        }
        reader_.take();
        return true;
    }

    static bool parse(std::string_view text, std::uint64_t& value) {
        int base = 10;
        if (text.size() > 1 && text[0] == '0') {
            base = text[1] == 'x' || text[1] == 'X' ? 16 : 8;
            text.remove_prefix(base == 16 ? 2 : 1);
        }
        const auto result = std::from_chars(text.data(), text.data() + text.size(), value, base);
        return result.ec == std::errc() && result.ptr == text.data() + text.size();
    }

    struct Deeper {
        explicit Deeper(std::size_t& depth) : depth(depth) { ++depth; }
        ~Deeper() { --depth; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;
        std::size_t& depth;
    };

    IdlReader& reader_;
    const IdlNames& names_;
    const std::string& scope_;
    std::size_t depth_ = 0;
};

}  // namespace

bool readNumber(IdlReader& reader, const IdlNames& names, const std::string& scope, std::int64_t& number,
                bool isWithinAngles) {
    return Expression(reader, names, scope).read(number, isWithinAngles);
}

}  // namespace oroforge::schema
