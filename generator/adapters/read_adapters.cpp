// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <adapters/read_adapters.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <adapters/name_pattern.hpp>
#include <diag/embedded_files.hpp>
#include <xml/document.hpp>

#include "adapter_rules.hpp"

namespace oroforge::embedded {
diag::EmbeddedFiles shippedAdapters();
}

namespace oroforge::adapters {

namespace {

std::string withoutBlanks(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (std::isspace(static_cast<unsigned char>(c)) == 0) result += c;
    return result;
}

bool isIdentifier(const std::string& text) {
    if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) != 0) return false;
    for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') return false;
    return true;
}

/// Splits "std::complex<double>, $N" at the commas outside brackets.
std::vector<Pattern> splitArguments(const std::string& text, bool keepBlanks = false) {
    std::vector<Pattern> parts(1);
    int depth = 0;
    for (const char c : keepBlanks ? text : withoutBlanks(text)) {
        if (c == '<' || c == '(') ++depth;
        if (c == '>' || c == ')') --depth;
        if (c == ',' && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

class Reader {
public:
    Reader(bool isShipped, diag::Sink& sink) : isShipped_(isShipped), sink_(sink) {}

    Adapter read(const xml::Element& element) {
        Adapter result;
        result.isShipped = isShipped_;
        result.where = element.where;
        result.shape = element.name == "struct"     ? Shape::Struct
                       : element.name == "sequence" ? Shape::Sequence
                                                    : Shape::Matrix;
        readClass(element, result);
        result.doc = element.attributeOr("doc", "");
        const Names element1 = result.shape == Shape::Matrix ? Names{"row", "column"} : Names{"index"};
        result.size = accessor(element, "size", {});
        result.rows = accessor(element, "rows", {});
        result.columns = accessor(element, "columns", {});
        result.resize =
            accessor(element, "resize", result.shape == Shape::Matrix ? Names{"rows", "columns"} : Names{"size"});
        if (!result.resize.steps.empty()) checkResize(result);
        result.element = accessor(element, "element", element1);
        result.set = setter(element, element1);
        checkSizes(result);
        result.initial = accessor(element, "initial", {});
        for (const xml::Element& child : element.children) {
            if (child.name == "constructor")
                readConstructor(child, result);
            else
                readMember(child, result);
        }
        if (result.shape == Shape::Struct && result.members.empty())
            sink_.error(element.where, "TK070", "<struct> without a <member>");
        return result;
    }

private:
    using Names = std::vector<std::string>;

    void error(const xml::Attribute& attribute, const std::string& what) {
        sink_.error(attribute.valueWhere, "TK070",
                    "attribute '" + attribute.name + "' is '" + attribute.value + "', " + what);
    }

    void readClass(const xml::Element& element, Adapter& into) {
        const xml::Attribute& name = *element.attribute("class");
        into.classWhere = name.valueWhere;
        into.className = name.value.compare(0, 2, "::") == 0 ? name.value.substr(2) : name.value;
        std::string rest = into.className + "::";
        for (std::size_t end = rest.find("::"); end != std::string::npos; end = rest.find("::")) {
            if (!isIdentifier(rest.substr(0, end))) {
                error(
                    name,
                    "expected the name of a class, such as 'KDL::Vector'; arguments of a template go into 'arguments'");
                break;
            }
            rest = rest.substr(end + 2);
        }
        if (into.className.compare(0, 5, "std::") == 0)
            error(name, "but types of the standard library are described without an adapter, or not at all");
        std::set<std::string> variables;
        if (const xml::Attribute* arguments = element.attribute("arguments"))
            readArguments(*arguments, into, variables);
        into.name = typeName(element, "name", variables);
        into.alias = typeName(element, "alias", variables);
    }

    void readArguments(const xml::Attribute& attribute, Adapter& into, std::set<std::string>& variables) {
        into.arguments = splitArguments(attribute.value);
        for (const Pattern& part : into.arguments) {
            const bool isLast = &part == &into.arguments.back();
            if (part.empty()) return error(attribute, "expected an argument between the commas");
            if (part == "..." && !isLast) return error(attribute, "expected '...' as the last argument only");
            if (part[0] != '$') continue;
            if (!isIdentifier(part.substr(1))) return error(attribute, "expected a name behind '$' in '" + part + "'");
            variables.insert(part.substr(1));
        }
        variables_ = variables;
    }

    std::string typeName(const xml::Element& element, const char* key, const std::set<std::string>& variables) {
        const xml::Attribute* attribute = element.attribute(key);
        if (attribute == nullptr) return "";
        for (const NamePart& part : partsOf(attribute->value)) {
            if (part.isVariable) {
                if (!checkVariable(*attribute, part.text, variables)) return "";
                continue;
            }
            for (const char c : part.text) {
                if (std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                    std::string("_/<>,.:").find(c) != std::string::npos)
                    continue;
                error(*attribute, "expected letters, digits and any of '_/<>,.:'");
                return "";
            }
        }
        return attribute->value;
    }

    bool checkVariable(const xml::Attribute& attribute, const std::string& name,
                       const std::set<std::string>& variables) {
        if (variables.count(name) != 0) return true;
        error(attribute, "but '$" + name + "' is no argument of the template: 'arguments' must name it");
        return false;
    }

    Accessor accessor(const xml::Element& element, const char* key, const Names& words) {
        const xml::Attribute* attribute = element.attribute(key);
        if (attribute == nullptr) return {};
        Accessor result = parseAccessor(attribute->value, attribute->valueWhere, words, sink_);
        checkVariables(*attribute, result.number);
        for (const Step& step : result.steps)
            for (const std::string& argument : step.arguments) checkVariables(*attribute, argument);
        const std::string name = key;
        if (!result.number.empty() && name != "size" && name != "rows" && name != "columns")
            error(*attribute, "a number, expected how to reach a part of the object");
        return result;
    }

    void checkVariables(const xml::Attribute& attribute, const std::string& word) {
        if (!word.empty() && word[0] == '$') checkVariable(attribute, word.substr(1), variables_);
    }

    Accessor setter(const xml::Element& element, Names words) {
        words.push_back("value");
        return accessor(element, "set", words);
    }

    /// If a size can change, 'resize' must take it as an argument.
    void checkResize(const Adapter& adapter) {
        const std::pair<const Accessor*, const char*> all[] = {
            {&adapter.size, "size"}, {&adapter.rows, "rows"}, {&adapter.columns, "columns"}};
        for (const auto& [count, word] : all) {
            if (count->given() && count->number.empty() && !adapter.resize.uses(word))
                sink_.error(
                    adapter.resize.where, "TK070",
                    "attribute 'resize' is '" + adapter.resize.text + "', expected '" + word + "' among its arguments");
        }
    }

    void checkSizes(const Adapter& adapter) {
        const bool isFixed = adapter.shape == Shape::Matrix
                                 ? !adapter.rows.number.empty() && !adapter.columns.number.empty()
                                 : !adapter.size.number.empty();
        if (isFixed && adapter.resize.given())
            sink_.error(adapter.resize.where, "TK070", "'resize' although the size is a number, which never changes");
        for (const Accessor* one : {&adapter.size, &adapter.rows, &adapter.columns}) {
            if (one->number.empty() || one->number[0] == '$' || std::stoul(one->number) != 0) continue;
            sink_.error(one->where, "TK070", "a size of 0, expected at least one element");
        }
    }

    /// Reads "double x, KDL::Vector p".
    void readConstructor(const xml::Element& element, Adapter& into) {
        Constructor made;
        made.where = element.where;
        const xml::Attribute& attribute = *element.attribute("arguments");
        Names words;
        for (const Pattern& part : splitArguments(attribute.value, /*keepBlanks=*/true)) {
            Constructor::Argument argument = constructorArgument(part);
            argument.where = attribute.valueWhere;
            if (!isIdentifier(argument.name) || argument.type.empty())
                return error(attribute, "expected arguments with their types, such as 'double x, KDL::Vector p'");
            if (argument.type[0] == '$') checkVariable(attribute, argument.type.substr(1), variables_);
            if (std::find(words.begin(), words.end(), argument.name) != words.end())
                return error(attribute, "but two arguments are called '" + argument.name + "'");
            words.push_back(argument.name);
            made.arguments.push_back(argument);
        }
        made.call = accessor(element, "call", words);
        into.constructors.push_back(made);
    }

    static Constructor::Argument constructorArgument(const std::string& text) {
        const std::size_t end = text.find_last_not_of(' ');
        const std::size_t begin = text.find_last_of(' ', end) + 1;  // start of the name, unless there is only one word
        if (end == std::string::npos || begin == 0) return {};
        const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ', begin - 1);
        if (first >= begin || last == std::string::npos) return {};
        const std::string type = text.substr(first, last - first + 1);
        return {type.compare(0, 2, "::") == 0 ? type.substr(2) : type, text.substr(begin, end - begin + 1), {}};
    }

    void readMember(const xml::Element& element, Adapter& into) {
        Member member;
        const xml::Attribute& name = *element.attribute("name");
        member.where = element.where;
        member.name = name.value;
        if (!isIdentifier(name.value)) error(name, "expected a name of letters, digits and '_'");
        if (const xml::Attribute* also = element.attribute("also")) {
            member.also = also->value;
            if (!isIdentifier(also->value)) error(*also, "expected a name of letters, digits and '_'");
        }
        member.doc = element.attributeOr("doc", "");
        member.unit = element.attributeOr("unit", "");
        member.range = element.attributeOr("range", "");
        member.get = accessor(element, "get", {});
        member.set = setter(element, {});
        for (const Member& other : into.members) {
            const bool isKnown = other.name == member.name || other.also == member.name ||
                                 (!member.also.empty() && (other.name == member.also || other.also == member.also));
            if (isKnown)
                sink_.error(name.valueWhere, "TK075", "member '" + member.name + "' is there already")
                    .note(other.where, "the first is here");
        }
        into.members.push_back(member);
    }

    bool isShipped_;
    diag::Sink& sink_;
    std::set<std::string> variables_;
};

/// Replaces the names of $variables: only the places of equal names matter.
std::vector<Pattern> withoutNames(const std::vector<Pattern>& arguments) {
    std::map<Pattern, std::size_t> numbers;
    std::vector<Pattern> result;
    for (const Pattern& part : arguments)
        result.push_back(part[0] == '$' ? "$" + std::to_string(numbers.emplace(part, numbers.size()).first->second)
                                        : part);
    return result;
}

void add(const std::optional<xml::Document>& document, bool isShipped, std::vector<Adapter>& to, diag::Sink& sink) {
    if (!document || !checkStructure(document->root(), sink)) return;
    const std::size_t before = sink.errorCount();
    std::vector<Adapter> found;
    for (const xml::Element& element : document->root().children)
        found.push_back(Reader(isShipped, sink).read(element));
    if (sink.errorCount() != before) return;
    for (const Adapter& adapter : found) {
        for (const Adapter& other : to) {
            if (other.isShipped != isShipped || other.className != adapter.className ||
                withoutNames(other.arguments) != withoutNames(adapter.arguments))
                continue;
            sink.error(adapter.classWhere, "TK075", "a second adapter for '" + adapter.className + "'")
                .note(other.classWhere, "the first is here");
            break;
        }
        to.push_back(adapter);
    }
}

}  // namespace

std::vector<Adapter> readAdapters(const std::vector<std::string>& files, diag::Sink& sink) {
    std::vector<Adapter> result;
    std::set<std::string> seen;
    for (const std::string& file : files) {
        if (seen.insert(file).second) add(xml::Document::parseFile(file, sink), false, result, sink);
    }
    for (const diag::EmbeddedFile& file : embedded::shippedAdapters())
        add(xml::Document::parseText(std::string(file.text), std::string(file.name), sink), true, result, sink);
    return result;
}

}  // namespace oroforge::adapters
