// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_literal.hpp>

#include <algorithm>
#include <charconv>
#include <limits>

namespace RTT::scripting::detail {

namespace {

typedef std::optional<LiteralProblem> Problem;

LiteralProblem badNumber(std::string message) { return {"OPS006", 0, std::move(message)}; }

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

template <class T>
Problem within(unsigned long long magnitude, std::string_view number, ast::Value& value, const char* hint = "") {
    constexpr T most = std::numeric_limits<T>::max();
    if (magnitude > static_cast<unsigned long long>(most))
        return badNumber("found " + std::string(number) + ", expected at most " + std::to_string(most) + hint);
    value = static_cast<T>(magnitude);
    return {};
}

/** Units per second, as a divisor, because division rounds correctly. */
double unitsPerSecond(const std::string& unit) {
    if (unit == "s") return 1;
    if (unit == "ms") return 1e3;
    if (unit == "us") return 1e6;
    return unit == "ns" ? 1e9 : 0;
}

Problem readWhole(std::string_view number, bool hex, ast::Value& value) {
    const std::string_view digits = number.substr(hex ? 2 : 0);
    unsigned long long magnitude = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), magnitude, hex ? 16 : 10);
    if (read.ec == std::errc::invalid_argument)
        return badNumber("found '" + std::string(number) + "', expected hexadecimal digits after '0x'");
    const auto length = static_cast<std::size_t>(read.ptr - digits.data());
    const std::string suffix = lower(digits.substr(length));
    const double units = hex ? 0 : unitsPerSecond(suffix);
    if (!suffix.empty() && suffix != "u" && suffix != "ll" && suffix != "ull" && units == 0) {
        const char* expected = suffix == "f" ? "', expected a '.' before 'f'"
                               : hex         ? "', expected digits from 0 to f, 'u', 'll' or 'ull'"
                                     : "' after a whole number, expected 'u', 'll', 'ull', 's', 'ms', 'us' or 'ns'";
        return badNumber("found '" + std::string(suffix == "f" ? number : digits.substr(length)) + expected);
    }
    if (read.ec == std::errc::result_out_of_range)
        return badNumber("found " + std::string(number) + ", expected at most 18446744073709551615");
    if (units != 0) {
        value = static_cast<double>(magnitude) / units;
        return {};
    }
    if (suffix == "ull") return within<unsigned long long>(magnitude, number, value);
    if (suffix == "ll") return within<long long>(magnitude, number, value, "; 'ull' makes it unsigned");
    if (suffix == "u" || hex) return within<unsigned int>(magnitude, number, value, "; 'ull' makes it longer");
    return within<int>(magnitude, number, value, "; 'u' makes it unsigned, 'll' longer");
}

template <class T>
Problem readReal(std::string_view number, ast::Value& value) {
    T real = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), real);
    if (read.ec != std::errc())
        return badNumber("found " + std::string(number) + ", expected a number that fits a " +
                         (sizeof(T) == sizeof(float) ? "float" : "double"));
    value = real;
    return {};
}

int digitOf(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return 16;
}

/** The value of at most `most` digits from `at` on; moves `at` behind them. */
unsigned numeral(std::string_view text, std::size_t& at, int base, std::size_t most) {
    unsigned value = 0;
    const std::size_t end = std::min(text.size(), at + most);
    for (; at < end && digitOf(text[at]) < base; ++at)
        value = value * static_cast<unsigned>(base) + static_cast<unsigned>(digitOf(text[at]));
    return value;
}

/** Reads the letter of the escape at `at` (a '\'); moves `at` behind it. */
Problem readEscape(std::string_view body, std::size_t& at, char& letter) {
    static constexpr char names[] = "nrtabfv\\\"'?", letters[] = "\n\r\t\a\b\f\v\\\"'?";
    const std::size_t begin = at++;
    const char c = body[at];
    const auto problem = [&](const std::string& message) { return LiteralProblem{"OPS007", begin, message}; };
    if (digitOf(c) < 8) {
        const unsigned value = numeral(body, at, 8, 3);
        letter = static_cast<char>(value);
        if (value <= 0xFF) return {};
        return problem("found '" + std::string(body.substr(begin, at - begin)) + "', expected at most '\\377'");
    }
    ++at;
    if (c == 'x' || c == 'X') {
        const std::size_t digits = at;
        letter = static_cast<char>(numeral(body, at, 16, 2));
        if (at > digits) return {};
        return problem("found '\\" + std::string(1, c) + "', expected two hexadecimal digits after it");
    }
    const std::size_t known = std::string_view(names).find(c);
    if (known != std::string_view::npos) {
        letter = letters[known];
        return {};
    }
    letter = c;
    return problem("found '\\" + std::string(1, c) + "', expected an escape such as '\\n', or '\\\\' for a backslash");
}

}  // namespace

Problem readNumber(std::string_view number, ast::Value& value) {
    const bool hex = number.size() > 1 && number[0] == '0' && (number[1] == 'x' || number[1] == 'X');
    const std::size_t digitsEnd = std::min(number.find_first_not_of("0123456789"), number.size());
    std::size_t end = digitsEnd;
    if (!hex && end < number.size() && number[end] == '.') ++end;
    end = std::min(number.find_first_not_of("0123456789", end), number.size());
    if (!hex && end + 1 < number.size() && (number[end] == 'e' || number[end] == 'E')) {
        const std::size_t digits = end + (number[end + 1] == '+' || number[end + 1] == '-' ? 2 : 1);
        const std::size_t exponentEnd = std::min(number.find_first_not_of("0123456789", digits), number.size());
        if (exponentEnd > digits) end = exponentEnd;
    }
    if (hex || end == digitsEnd) return readWhole(number, hex, value);
    const std::string_view suffix = number.substr(end);
    if (suffix.empty()) return readReal<double>(number, value);
    if (suffix == "f" || suffix == "F") return readReal<float>(number.substr(0, end), value);
    return badNumber("found '" + std::string(suffix) +
                     "' after a number with fraction or exponent, expected 'f' or nothing");
}

bool readLeast(std::string_view number, ast::Value& value) {
    unsigned long long magnitude = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), magnitude);
    if (read.ec != std::errc()) return false;
    const std::string suffix = lower(number.substr(static_cast<std::size_t>(read.ptr - number.data())));
    const auto isLeast = [&](auto least) {
        if (magnitude != 0 - static_cast<unsigned long long>(least)) return false;
        value = least;
        return true;
    };
    if (suffix.empty()) return isLeast(std::numeric_limits<int>::min());
    return suffix == "ll" && isLeast(std::numeric_limits<long long>::min());
}

Problem readText(std::string_view quoted, std::string& text) {
    const std::string_view body = quoted.substr(1, quoted.size() - 2);
    Problem first;
    text.clear();
    text.reserve(body.size());
    for (std::size_t at = 0; at < body.size();) {
        char letter = body[at];
        if (letter != '\\') {
            ++at;
        } else {
            Problem problem = readEscape(body, at, letter);
            if (problem && !first) first = std::move(problem);
        }
        text += letter;
    }
    if (first) ++first->offset;
    return first;
}

Problem readLetter(std::string_view quoted, char& letter) {
    std::string text;
    Problem problem = readText(quoted, text);
    if (problem) return problem;
    if (text.size() != 1)
        return LiteralProblem{
            "OPS007", 0,
            "found " + std::string(quoted) + ", expected one letter of one byte; put texts into double quotes"};
    letter = text[0];
    return {};
}

}  // namespace RTT::scripting::detail
