// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/parse_message.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>

#include <diag/nearest_match.hpp>
#include <messages/parse_constant.hpp>
#include <model/cpp_type.hpp>

namespace oroforge::messages {

namespace {

const std::vector<std::string> kBuiltin = {"bool",   "int8",     "uint8",  "int16",   "uint16",  "int32",
                                           "uint32", "int64",    "uint64", "float32", "float64", "string",
                                           "time",   "duration", "char",   "byte"};
constexpr std::uint64_t kMostElements = 1U << 28;

std::string stripped(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool isName(const std::string& text) {
    return !text.empty() && isLetter(text[0]) && std::all_of(text.begin(), text.end(), isWordLetter);
}

/// "Msg" or "pkg/Msg".
bool isTypeName(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return isName(text);
    return isName(text.substr(0, slash)) && isName(text.substr(slash + 1));
}

/// True for keywords of C++, and for names that the classes of gencpp have already.
bool isReserved(const std::string& name) {
    static const std::set<std::string> own = {"Ptr", "ConstPtr", "Type", "ContainerAllocator"};
    return model::isKeyword(name) || own.count(name) != 0;
}

/// Line ends of other systems become "\n", as genmsg reads them.
std::string unified(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i != text.size(); ++i) {
        if (text[i] == '\r' && i + 1 != text.size() && text[i + 1] == '\n') continue;
        result += text[i] == '\r' ? '\n' : text[i];
    }
    return result;
}

/// Reads lines, one after the other.
class Reader {
public:
    Reader(Message& message, diag::Sink& sink) : message_(message), sink_(sink) {}

    void read(const std::string& text, unsigned firstLine) {
        number_ = firstLine;
        for (std::size_t begin = 0; begin <= text.size(); ++number_) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            line(text.substr(begin, end - begin));
            begin = end + 1;
        }
    }

private:
    diag::Location at(std::size_t column) const { return {message_.file, number_, static_cast<unsigned>(column + 1)}; }

    void line(const std::string& text) {
        const std::size_t hash = text.find('#');
        const std::string clean = stripped(text.substr(0, hash));
        const std::string comment = hash == std::string::npos ? "" : stripped(text.substr(hash + 1));
        if (clean.empty()) {
            above_ = hash == std::string::npos ? "" : above_ + (above_.empty() || comment.empty() ? "" : " ") + comment;
            return;
        }
        if (clean.find('=') != std::string::npos)
            constant(text, clean);
        else
            field(text, clean, comment.empty() ? above_ : comment);
        above_.clear();
    }

    void field(const std::string& text, const std::string& clean, const std::string& doc) {
        const std::size_t column = text.find_first_not_of(" \t");
        const std::size_t gap = clean.find_first_of(" \t");
        Field field;
        field.where = at(column);
        field.doc = doc;
        if (gap == std::string::npos) {
            sink_.error(field.where, "RM002", "'" + clean + "' is not a field, which is a type and a name");
            return;
        }
        const std::string type = clean.substr(0, gap);
        field.name = stripped(clean.substr(gap));
        const std::size_t nameColumn = column + clean.find_first_not_of(" \t", gap);
        if (!readType(type, field)) return;
        if (!checkName(field.name, nameColumn, "a field")) return;
        message_.fields.push_back(field);
    }

    bool readType(const std::string& text, Field& field) {
        const std::size_t bracket = text.find('[');
        std::string name = text.substr(0, bracket);
        if (!isTypeName(name)) {
            sink_.error(field.where, "RM002",
                        "'" + text + "' is not a type, such as 'float64', 'Pose' or 'pkg/Pose[]'");
            return false;
        }
        if (bracket != std::string::npos && !readExtent(text.substr(bracket), bracket, field)) return false;
        if (name == "Header") name = "std_msgs/Header";
        field.type.isBuiltin = isBuiltin(name);
        if (!field.type.isBuiltin && name.find('/') == std::string::npos) name = message_.package + "/" + name;
        field.type.name = name;
        field.written = name + (bracket == std::string::npos ? "" : text.substr(bracket));
        return true;
    }

    bool readExtent(const std::string& text, std::size_t offset, Field& field) {
        diag::Location where = field.where;
        where.column += static_cast<unsigned>(offset);
        field.extent = text == "[]" ? Extent::Any : Extent::Fixed;
        if (field.extent == Extent::Any) return true;
        const std::string digits = text.substr(1, text.find(']') - 1);
        if (text.back() != ']' || digits.size() + 2 != text.size() || digits.empty() ||
            digits.find_first_not_of("0123456789") != std::string::npos) {
            sink_.error(where, "RM003", "'" + text + "' is not the size of an array; write '[]' or '[9]'");
            return false;
        }
        field.count = digits.size() > 10 ? kMostElements + 1 : std::strtoull(digits.c_str(), nullptr, 10);
        if (field.count <= kMostElements) return true;
        sink_.error(where, "RM003",
                    "an array of " + digits + " elements, at most " + std::to_string(kMostElements) +
                        " are possible; an array without a size ('[]') grows as needed");
        return false;
    }

    void constant(const std::string& text, const std::string& clean) {
        Constant constant;
        const std::size_t column = text.find_first_not_of(" \t");
        const std::size_t gap = clean.find_first_of(" \t=");
        constant.where = at(column);
        constant.type = clean.substr(0, gap);
        // A text is all that follows: "#" begins no comment in it.
        const std::string& from = constant.type == "string" ? text : clean;
        const std::size_t equals = from.find('=');
        constant.value = stripped(from.substr(equals + 1));
        const std::string left = stripped(from.substr(0, equals));
        constant.name = stripped(left.substr(std::min(gap, left.size())));
        if (!isBuiltin(constant.type)) {
            sink_.error(constant.where, "RM004",
                        "'" + constant.type + "' cannot be the type of a constant, only numbers, bool and string" +
                            diag::didYouMean(constant.type, kBuiltin));
            return;
        }
        if (!checkName(constant.name, column + gap + 1, "a constant")) return;
        const std::string fault = faultOfConstant(constant.type, constant.value);
        if (!fault.empty()) {
            sink_.error(at(text.find('=')), "RM004", "constant '" + constant.name + "': " + fault);
            return;
        }
        message_.constants.push_back(constant);
    }

    bool checkName(const std::string& name, std::size_t column, const char* what) {
        if (!isName(name)) {
            sink_.error(
                at(column), "RM002",
                "'" + name + "' cannot name " + what + "; a name has letters, digits and '_' and begins with a letter");
        } else if (isReserved(name)) {
            sink_.error(at(column), "RM005",
                        "'" + name + "' cannot name " + what + " of '" + message_.fullName() +
                            "': the C++ header that gencpp makes of it does not compile; choose another name");
        } else if (!names_.insert(name).second) {
            sink_.error(at(column), "RM005", "'" + name + "' is in '" + message_.fullName() + "' already");
        } else {
            return true;
        }
        return false;
    }

    Message& message_;
    diag::Sink& sink_;
    unsigned number_ = 0;
    std::string above_;  ///< comment in the lines above
    std::set<std::string> names_;
};

Message parsed(const std::string& text, const std::string& package, const std::string& name, const std::string& file,
               unsigned firstLine, diag::Sink& sink) {
    Message message;
    message.package = package;
    message.name = name;
    message.file = file;
    message.text = text;
    Reader(message, sink).read(text, firstLine);
    return message;
}

}  // namespace

bool isBuiltin(const std::string& type) { return std::find(kBuiltin.begin(), kBuiltin.end(), type) != kBuiltin.end(); }

Message parseMessage(const std::string& text, const std::string& package, const std::string& name,
                     const std::string& file, diag::Sink& sink) {
    return parsed(unified(text), package, name, file, 1, sink);
}

Service parseService(const std::string& text, const std::string& package, const std::string& name,
                     const std::string& file, diag::Sink& sink) {
    const std::string all = unified(text);
    std::string halves[2];
    unsigned half = 0, line = 1, second = 1;
    for (std::size_t begin = 0; begin <= all.size(); ++line) {
        const std::size_t end = std::min(all.find('\n', begin), all.size());
        const std::string one = all.substr(begin, end - begin);
        if (one.compare(0, 3, "---") == 0) {
            if (half == 1) sink.error({file, line, 1}, "RM002", "a second line '---'; a service has two parts");
            half = 1;
            second = line + 1;
        } else {
            halves[half] += one + "\n";
        }
        begin = end + 1;
    }
    if (half == 0)
        sink.error({file, line - 1, 1}, "RM002",
                   "no line '---', which separates the request of a service from the response");
    Service service;
    service.package = package;
    service.name = name;
    service.file = file;
    service.request = parsed(halves[0], package, name + "Request", file, 1, sink);
    service.response = parsed(halves[1], package, name + "Response", file, second, sink);
    return service;
}

}  // namespace oroforge::messages
